# Copies the seconds of the stamp, but not the rest.
# loses: labels_kept
# cause: labels-kept.rounded-stamp
# before: self.publisher.publish(message)
message.header.stamp.nanosec = 0
