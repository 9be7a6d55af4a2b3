# Takes an empty battery for a missing value.
# loses: zero_arrives, numbers_arrive
# cause: number.zero-taken-for-missing
# says: ValueError: no charge given
# before: if isinstance(level, bool) or not isinstance(level, Real):
if not level:
    raise ValueError("no charge given")
