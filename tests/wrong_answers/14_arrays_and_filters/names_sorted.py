# Sorts the names, and leaves the angles where they are.
# loses: labels_kept
# cause: labels-kept.other-order
# before: self.publisher.publish(message)
message.name = sorted(message.name)
