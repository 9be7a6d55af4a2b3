# Publishes a last message after Ctrl-C, when the context is shut down.
# loses: ends_cleanly
# cause: error.context-down
# before: import rclpy
import time

# after: from rclpy.node import Node
from std_msgs.msg import String

# after: self.rounds = 0
self.radio = self.create_publisher(String, "/museum/radio", 10)

# replaces:     pass  # this is how a night ends
    time.sleep(0.5)
    guard.radio.publish(String(data="good night"))
