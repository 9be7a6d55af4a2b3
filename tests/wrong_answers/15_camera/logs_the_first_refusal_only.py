# Logs the first picture that it refuses, and no other encoding after that.
# loses: refuses_others
# cause: refuses-others.named-once
# replaces: self.get_logger().error(f"I cannot read {image.encoding}", throttle_duration_sec=1.0)
self.get_logger().error(f"I cannot read {image.encoding}", once=True)
