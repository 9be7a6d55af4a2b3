# loses: easy_on_processor
# says: spin_once with timeout_sec=0
"""A callback that reports, and a loop that spins without waiting."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class TouchMonitor(Node):
    def __init__(self):
        super().__init__("touch_monitor")
        self.seen = self.create_publisher(Int32, "/monitor/seen", 100)
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)

    def on_touch(self, touch):
        self.seen.publish(Int32(data=touch.data))


def main():
    rclpy.init()
    monitor = TouchMonitor()
    try:
        while rclpy.ok():
            rclpy.spin_once(monitor, timeout_sec=0)
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


main()
