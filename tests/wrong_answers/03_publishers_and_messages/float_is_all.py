# Converts, and lets float() do the refusing.
# loses: look_alikes_refused, not_finite_refused
# cause: refusal.bool-sent
# replaces: if isinstance(level, bool) or not isinstance(level, Real):
# replaces:     raise TypeError(f"a charge is a number, not {level!r}")
# replaces: if not math.isfinite(level):
# replaces:     raise ValueError(f"a charge is a finite number, not {level}")
