# Collects pairs of answers, and sends the newer one first.
# loses: every_one_answered
# cause: every-one-answered.other-order, every-one-answered.held-back
# after: super().__init__("joint_filter")
self.pair: list[JointState] = []

# replaces: self.publisher.publish(message)
self.pair.append(message)
if len(self.pair) == 2:
    self.publisher.publish(self.pair.pop())
    self.publisher.publish(self.pair.pop())
