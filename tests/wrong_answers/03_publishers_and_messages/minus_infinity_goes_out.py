# Finds one of the two infinities.
# loses: not_finite_refused
# cause: refusal.negative-infinity
# says: publish_level(-inf)
# replaces: if not math.isfinite(level):
if level != level or level == math.inf:
