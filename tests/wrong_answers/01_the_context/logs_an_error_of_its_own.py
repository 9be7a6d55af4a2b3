# Wants to say goodbye by radio after Ctrl-C, catches the error, and logs it with its traceback.
# loses: ends_cleanly
# cause: exits-cleanly.prints-an-error
# before: import rclpy
import logging

# after: from rclpy.node import Node
from std_msgs.msg import String

# after: guard.park()
try:
    guard.create_publisher(String, "/goodbye", 10)
except Exception:
    logging.exception("no goodbye")
