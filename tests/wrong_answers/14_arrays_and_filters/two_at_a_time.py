# Collects two messages, and answers both.
# loses: every_one_answered
# cause: every-one-answered.held-back
# after: self.memory: np.ndarray | None = None
self.held: list[JointState] = []

# replaces: self.publisher.publish(message)
self.held.append(message)
if len(self.held) == 2:
    for one in self.held:
        self.publisher.publish(one)
    self.held.clear()
