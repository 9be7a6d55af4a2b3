# Publishes each answer when the next message comes.
# loses: every_one_answered
# cause: every-one-answered.held-back
# after: super().__init__("joint_filter")
self.waiting: JointState | None = None

# replaces: self.publisher.publish(message)
if self.waiting is not None:
    self.publisher.publish(self.waiting)
self.waiting = message
