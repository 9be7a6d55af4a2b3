# The newest executor: its spin() never calls back in this build.
# loses: answers_come
# skips: labels_kept, every_one_answered, filters, noise_reduced, delay_bounded, begins_near, restart_noticed, survives_nan
# cause: answers-come.nothing
# before: from rclpy.node import Node
from rclpy.experimental import EventsExecutor

# replaces: rclpy.spin(JointFilter())
executor = EventsExecutor()
executor.add_node(JointFilter())
executor.spin()
