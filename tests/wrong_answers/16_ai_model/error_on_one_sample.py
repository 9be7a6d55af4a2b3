# Takes one tilted sample for a fall.
# loses: fall_reported
# cause: fall-reported.on-a-jolt
# replaces: self.fallen = self.fallen or self.tilted >= TILTED_SAMPLES
self.fallen = self.fallen or self.tilted > 0
