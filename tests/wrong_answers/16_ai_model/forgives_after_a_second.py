# Says "operational" again when the robot has been upright for a second.
# loses: fall_reported
# cause: fall-reported.forgiven
# after: self.fallen = False
self.upright = 0
# after: self.fallen = self.fallen or self.tilted >= TILTED_SAMPLES
self.upright = 0 if self.tilted else self.upright + 1
self.fallen = self.fallen and self.upright < 50
