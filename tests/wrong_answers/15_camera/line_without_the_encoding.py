# Logs that it cannot read a picture, and not what it was.
# loses: refuses_others
# cause: refuses-others.no-line
# replaces: self.get_logger().error(f"I cannot read {image.encoding}", throttle_duration_sec=1.0)
self.get_logger().error("I cannot read this picture", throttle_duration_sec=1.0)
