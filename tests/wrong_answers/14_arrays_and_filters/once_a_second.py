# Collects answers, and sends them once a second, in order.
# loses: every_one_answered
# cause: every-one-answered.late
# after: super().__init__("joint_filter")
self.collected: list[JointState] = []
self.create_timer(1.0, self.publish_all)

# before: def on_joints(self, message: JointState) -> None:
def publish_all(self) -> None:
    for message in self.collected:
        self.publisher.publish(message)
    self.collected.clear()

# replaces: self.publisher.publish(message)
self.collected.append(message)
