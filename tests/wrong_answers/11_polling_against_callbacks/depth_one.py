# loses: none_missed
# says: such as came together with others
# says: a queue with a small depth
"""A callback, but the subscription holds only one touch, and each report is written to a slow log first."""

import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class TouchMonitor(Node):
    def __init__(self):
        super().__init__("touch_monitor")
        self.seen = self.create_publisher(Int32, "/monitor/seen", 100)
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 1)

    def on_touch(self, touch):
        time.sleep(0.002)  # the log
        self.seen.publish(Int32(data=touch.data))


def main():
    rclpy.init()
    try:
        rclpy.spin(TouchMonitor())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


main()
