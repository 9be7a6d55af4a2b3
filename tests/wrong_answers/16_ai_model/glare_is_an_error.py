# The status becomes "error" when the model raises.
# loses: fall_reported
# cause: fall-reported.on-glare
# after: self.get_logger().error(f"The model gave up: {error}")
self.fallen = True
