# Says "operational" again when the robot stands.
# loses: fall_reported
# cause: fall-reported.taken-back
# replaces: self.fallen = self.fallen or self.tilted >= TILTED_SAMPLES
self.fallen = self.tilted >= TILTED_SAMPLES
