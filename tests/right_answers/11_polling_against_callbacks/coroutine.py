"""An async callback, and the old attributes are still there for who wants to look."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class TouchMonitor(Node):
    def __init__(self):
        super().__init__("touch_monitor")
        self.seen = self.create_publisher(Int32, "/monitor/seen", 100)
        self.last = 0
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)

    async def on_touch(self, touch):
        self.last = touch.data
        self.seen.publish(Int32(data=self.last))


def main():
    rclpy.init()
    try:
        rclpy.spin(TouchMonitor())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


main()
