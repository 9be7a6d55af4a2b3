# loses: none_missed, quick
# says: the callback itself takes long
"""The callback works for a fifth of a second on each touch, and the queue holds five."""

import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class TouchMonitor(Node):
    def __init__(self):
        super().__init__("touch_monitor")
        self.seen = self.create_publisher(Int32, "/monitor/seen", 100)
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 5)

    def on_touch(self, touch):
        time.sleep(0.2)  # compute how hard it was
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
