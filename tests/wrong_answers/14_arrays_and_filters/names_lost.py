# A new message without names.
# loses: labels_kept
# skips: every_one_answered, filters, noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: labels-kept.no-names
# replaces: self.publisher.publish(message)
self.publisher.publish(JointState(header=message.header, position=message.position))
