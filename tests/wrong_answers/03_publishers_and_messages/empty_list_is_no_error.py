# Takes an empty list for "nothing to report".
# loses: no_number_refused
# cause: refusal.silent
# says: publish_level([])
# before: if isinstance(level, bool) or not isinstance(level, Real):
if isinstance(level, list) and not level:
    return
