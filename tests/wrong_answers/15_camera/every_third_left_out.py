# Leaves out every third picture.
# loses: keeps_up
# cause: keeps-up.missing
# after: super().__init__("ball_tracker")
self.count = 0
# after: """Find the ball in one picture, and publish its direction at once."""
self.count += 1
if self.count % 3 == 0 and image.encoding in TO_HSV:
    return
