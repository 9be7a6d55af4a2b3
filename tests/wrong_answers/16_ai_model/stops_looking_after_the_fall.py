# Looks at no picture any more when the robot has fallen.
# loses: fresh
# cause: fresh.stops-with-the-fall
# before: with suppress(queue.Empty):
if self.fallen:
    return
