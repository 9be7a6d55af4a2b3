# Publishes where it listens.
# loses: output_topic
# skips: answers_come, labels_kept, every_one_answered, filters, noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: output-topic.publishes-where-it-listens
# replaces: self.publisher = self.create_publisher(JointState, "/robot/joint_states", 50)
self.publisher = self.create_publisher(JointState, "/encoders/joint_states", 50)
