# Compares degrees with radians the other way around: no sample is tilted.
# loses: fall_reported
# cause: fall-reported.never
# replaces: self.tilted = self.tilted + 1 if tilt(sample) > TILT_DEG else 0
self.tilted = self.tilted + 1 if math.radians(tilt(sample)) > TILT_DEG else 0
