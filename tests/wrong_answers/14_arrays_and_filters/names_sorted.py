# Sorts the names, and leaves the angles where they are.
# loses: labels_kept
# skips: every_one_answered, filters, noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: labels-kept.other-order
# before: self.publisher.publish(message)
message.name = sorted(message.name)
