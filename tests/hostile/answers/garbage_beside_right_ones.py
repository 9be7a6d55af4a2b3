# score: 7
# loses: twelve_values, joint_rate
# says: could not be decoded
"""Beside each right message, bytes that are no message: whoever listens gets an error for each."""
import rclpy.publisher

_publish = rclpy.publisher.Publisher.publish


def publish(self, message):
    _publish(self, message)
    if self.topic_name == "/robot/joint_positions":
        _publish(self, b"\x00\x01\x00\x00\xff\xff\xff\x7f")


rclpy.publisher.Publisher.publish = publish
@@GOOD@@
