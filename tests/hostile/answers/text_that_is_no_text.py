# score: 9
# loses: status_kept
"""A right answer, but the status is no valid UTF-8."""
import rclpy.publisher

_publish = rclpy.publisher.Publisher.publish


def publish(self, message):
    if self.topic_name == "/robot/status":
        message = b"\x00\x01\x00\x00\x06\x00\x00\x00\xff\xfe\xfd\xc3\x28\x00"
    _publish(self, message)


rclpy.publisher.Publisher.publish = publish
@@GOOD@@
