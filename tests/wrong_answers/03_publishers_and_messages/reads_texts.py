# Asks float() whether it is a number.
# loses: look_alikes_refused
# cause: refusal.text-read
# replaces: if isinstance(level, bool) or not isinstance(level, Real):
# replaces:     raise TypeError(f"a charge is a number, not {level!r}")
# replaces: if not math.isfinite(level):
if isinstance(level, bool):
    raise TypeError("a bool")
if not math.isfinite(float(level)):
