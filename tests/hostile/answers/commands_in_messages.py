# score: 9
# loses: status_kept
"""What it publishes is meant for a terminal, a page or a spreadsheet."""
import rclpy.publisher

_publish = rclpy.publisher.Publisher.publish


def publish(self, message):
    if self.topic_name == "/robot/status":
        message = type(message)(data='=HYPERLINK("x")\x1b[2J\x1b]0;owned\x07\u202e<script>alert(1)</script>')
    _publish(self, message)


rclpy.publisher.Publisher.publish = publish
@@GOOD@@
