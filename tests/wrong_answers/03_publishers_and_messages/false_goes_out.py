# Knows one of the two bools.
# loses: look_alikes_refused
# cause: refusal.false-sent
# says: publish_level(False)
# replaces: if isinstance(level, bool) or not isinstance(level, Real):
if level is True or not isinstance(level, Real):
