import os
import signal

import rclpy
from std_msgs.msg import String


def crash(message: String) -> None:
    os.kill(os.getpid(), signal.SIGKILL)


rclpy.init()
node = rclpy.create_node("fragile_monitor")
node.create_subscription(String, "/robot/status", crash, 10)
rclpy.spin(node)
