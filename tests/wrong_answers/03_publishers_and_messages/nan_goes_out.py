# Knows all about types, and nothing about nan.
# loses: not_finite_refused
# cause: refusal.not-finite-sent
# replaces: if not math.isfinite(level):
# replaces:     raise ValueError(f"a charge is a finite number, not {level}")
