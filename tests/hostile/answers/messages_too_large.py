# score: 5
# says: larger than 4 MB
"""Five megabytes in each message."""
import rclpy.publisher

_publish = rclpy.publisher.Publisher.publish


def publish(self, message):
    if self.topic_name == "/robot/joint_positions":
        message = type(message)(data=[0.5] * 1_250_000)
    _publish(self, message)


rclpy.publisher.Publisher.publish = publish
@@GOOD@@
