# score: 7
# loses: twelve_values, joint_rate
# says: larger than 4 MB
"""Beside each right message, one of five megabytes."""
import rclpy.publisher

_publish = rclpy.publisher.Publisher.publish


def publish(self, message):
    _publish(self, message)
    if self.topic_name == "/robot/joint_positions":
        _publish(self, type(message)(data=[0.5] * 1_250_000))


rclpy.publisher.Publisher.publish = publish
@@GOOD@@
