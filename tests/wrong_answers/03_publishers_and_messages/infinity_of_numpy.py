# Asks for infinity among Python's floats only.
# loses: not_finite_refused
# cause: refusal.numpy-not-finite
# says: np.float32(-inf)
# replaces: if not math.isfinite(level):
if math.isnan(level) or (isinstance(level, float) and math.isinf(level)):
