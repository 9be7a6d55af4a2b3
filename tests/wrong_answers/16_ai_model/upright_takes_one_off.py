# An upright sample takes one off the count of tilted samples, and does not set it to 0.
# loses: fall_reported
# cause: fall-reported.counts-on
# replaces: self.tilted = self.tilted + 1 if tilt(sample) > TILT_DEG else 0
self.tilted = self.tilted + 1 if tilt(sample) > TILT_DEG else max(0, self.tilted - 1)
