# loses: none_missed, once_in_order
# says: A counter of your own
"""The callback counts for itself, from 0."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class TouchMonitor(Node):
    def __init__(self):
        super().__init__("touch_monitor")
        self.seen = self.create_publisher(Int32, "/monitor/seen", 100)
        self.count = 0
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)

    def on_touch(self, touch):
        self.seen.publish(Int32(data=self.count))
        self.count += 1


def main():
    rclpy.init()
    try:
        rclpy.spin(TouchMonitor())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


main()
