# Forgets that a bool is an int.
# loses: look_alikes_refused
# cause: refusal.bool-sent
# says: a bool
# replaces: if isinstance(level, bool) or not isinstance(level, Real):
if not isinstance(level, Real):
