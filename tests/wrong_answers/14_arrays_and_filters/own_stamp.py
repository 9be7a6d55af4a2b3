# Stamps the answer with the time of publishing.
# loses: labels_kept
# skips: every_one_answered, filters, noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: labels-kept.own-stamp
# before: self.publisher.publish(message)
message.header.stamp = self.get_clock().now().to_msg()
