# Takes a zero of NumPy's types for a missing value.
# loses: numbers_arrive
# cause: number.int-refused
# says: np.float32(0.0)
# before: if not math.isfinite(level):
if not isinstance(level, (int, float)) and not level:
    raise ValueError("no value")
