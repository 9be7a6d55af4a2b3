# Raises an exception for an encoding that it cannot read.
# loses: keeps_up, refuses_others, padding_right
# cause: error.exception
# replaces: self.get_logger().error(f"I cannot read {image.encoding}", throttle_duration_sec=1.0)
raise ValueError(f"I cannot read {image.encoding}")
