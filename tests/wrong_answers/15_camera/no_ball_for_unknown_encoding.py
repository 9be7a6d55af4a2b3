# Says that there is no ball where it could not look.
# loses: refuses_others
# cause: refuses-others.says-no-ball
# after: self.get_logger().error(f"I cannot read {image.encoding}", throttle_duration_sec=1.0)
self.publisher.publish(Vector3Stamped(header=image.header))
