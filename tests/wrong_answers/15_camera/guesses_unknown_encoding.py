# Publishes straight ahead where it could not look.
# loses: refuses_others
# cause: refuses-others.guesses
# after: self.get_logger().error(f"I cannot read {image.encoding}", throttle_duration_sec=1.0)
guess = Vector3Stamped(header=image.header)
guess.vector.z = 1.0
self.publisher.publish(guess)
