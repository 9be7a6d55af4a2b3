# One letter is missing in the name of the topic.
# loses: listens
# skips: answers_come, labels_kept, every_one_answered, filters, noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: listens.other-name
# replaces: self.create_subscription(JointState, "/encoders/joint_states", self.on_joints, 50)
self.create_subscription(JointState, "/encoder/joint_states", self.on_joints, 50)
