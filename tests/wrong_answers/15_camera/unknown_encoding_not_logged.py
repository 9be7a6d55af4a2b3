# Drops an encoding that it cannot read without a word.
# loses: refuses_others
# cause: refuses-others.no-line
# replaces: self.get_logger().error(f"I cannot read {image.encoding}", throttle_duration_sec=1.0)
