# A timer publishes the newest answer, five times a second: the others are lost.
# loses: every_one_answered
# cause: every-one-answered.missing
# after: super().__init__("joint_filter")
self.newest: JointState | None = None
self.create_timer(0.2, self.publish_newest)

# before: def on_joints(self, message: JointState) -> None:
def publish_newest(self) -> None:
    if self.newest is not None:
        self.publisher.publish(self.newest)
    self.newest = None

# replaces: self.publisher.publish(message)
self.newest = message
