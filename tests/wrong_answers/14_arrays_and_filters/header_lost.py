# A new message, and nobody copies the header.
# loses: labels_kept
# cause: labels-kept.no-stamp
# replaces: self.publisher.publish(message)
self.publisher.publish(JointState(name=message.name, position=message.position))
