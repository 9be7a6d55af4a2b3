# Forgets that a bool is an int.
# loses: look_alikes_refused
# cause: refusal.bool-sent
# replaces: if isinstance(level, bool) or not isinstance(level, Real):
if not isinstance(level, Real):
