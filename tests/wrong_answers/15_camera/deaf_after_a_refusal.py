# Ignores all pictures since it has met an encoding that it cannot read.
# loses: keeps_up, refuses_others, padding_right
# cause: keeps-up.silent-since
# after: super().__init__("ball_tracker")
self.broken = False
# after: """Find the ball in an image, and publish its direction right away."""
if self.broken:
    return
# after: self.get_logger().error(f"I cannot read {image.encoding}", throttle_duration_sec=1.0)
self.broken = True
