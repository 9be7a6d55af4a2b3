# A timer publishes the newest answer, twenty times a second.
# loses: every_one_answered
# cause: every-one-answered.repeated
# after: super().__init__("joint_filter")
self.newest: JointState | None = None
self.create_timer(0.05, self.publish_newest)

# before: def on_joints(self, message: JointState) -> None:
def publish_newest(self) -> None:
    if self.newest is not None:
        self.publisher.publish(self.newest)

# replaces: self.publisher.publish(message)
self.newest = message
