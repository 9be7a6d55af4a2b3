# Copies the seconds of the stamp, but not the rest.
# loses: labels_kept
# skips: every_one_answered, filters, noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: labels-kept.rounded-stamp
# before: self.publisher.publish(message)
message.header.stamp.nanosec = 0
