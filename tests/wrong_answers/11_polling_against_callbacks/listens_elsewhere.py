# loses: topics
# skips: none_missed, once_in_order, quick, easy_on_processor
# says: /robot/touches
"""The name of the topic has one letter too many."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class TouchMonitor(Node):
    def __init__(self):
        super().__init__("touch_monitor")
        self.seen = self.create_publisher(Int32, "/monitor/seen", 100)
        self.create_subscription(Int32, "/robot/touches", self.on_touch, 100)

    def on_touch(self, touch):
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
