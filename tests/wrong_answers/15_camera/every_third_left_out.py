# Leaves out every third picture.
# loses: keeps_up
# cause: keeps-up.missing
# after: super().__init__("ball_tracker")
self.count = 0
# after: """Find the ball in an image, and publish its direction right away."""
self.count += 1
if self.count % 3 == 0 and image.encoding in TO_HSV:
    return
