# Publishes an empty message when it starts, before any measurement has come.
# loses: labels_kept
# skips: every_one_answered, filters, noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: labels-kept.extra-message
# after: self.create_subscription(JointState, "/encoders/joint_states", self.on_joints, 50)
self.hello = self.create_timer(0.02, self.say_hello)
# before: def on_joints(self, message: JointState) -> None:
def say_hello(self) -> None:
    if self.publisher.get_subscription_count() > 0:
        self.hello.cancel()
        self.publisher.publish(JointState())

