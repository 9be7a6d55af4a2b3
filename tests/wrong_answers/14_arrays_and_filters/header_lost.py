# A new message, and nobody copies the header.
# loses: labels_kept
# skips: every_one_answered, filters, noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: labels-kept.no-stamp
# replaces: self.publisher.publish(message)
self.publisher.publish(JointState(name=message.name, position=message.position))
