# Hears every message twice.
# loses: every_one_answered, delay_bounded
# cause: every-one-answered.repeated
# after: self.create_subscription(JointState, "/encoders/joint_states", self.on_joints, 50)
self.create_subscription(JointState, "/encoders/joint_states", self.on_joints, 50)
