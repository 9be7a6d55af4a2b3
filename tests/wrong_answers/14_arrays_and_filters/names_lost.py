# A new message without names.
# loses: labels_kept
# cause: labels-kept.no-names
# replaces: self.publisher.publish(message)
self.publisher.publish(JointState(header=message.header, position=message.position))
