# Leaves the program at an encoding that it cannot read.
# loses: keeps_up, refuses_others, padding_right
# cause: refuses-others.silent-since
# after: self.get_logger().error(f"I cannot read {image.encoding}", throttle_duration_sec=1.0)
raise SystemExit(1)
