# Counts tilted samples, and never begins again.
# loses: fall_reported
# cause: fall-reported.on-a-jolt
# replaces: self.tilted = self.tilted + 1 if tilt(sample) > TILT_DEG else 0
self.tilted += tilt(sample) > TILT_DEG
