# loses: none_missed, easy_on_processor
# says: room for too few
"""The loop looks without a sleep."""

import threading
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class TouchMonitor(Node):
    def __init__(self):
        super().__init__("touch_monitor")
        self.seen = self.create_publisher(Int32, "/monitor/seen", 100)
        self.last = 0
        self.reported = 0
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)

    def on_touch(self, touch):
        self.last = touch.data

    def look(self):
        if self.last != self.reported:
            self.reported = self.last
            self.seen.publish(Int32(data=self.reported))


def main():
    rclpy.init()
    monitor = TouchMonitor()
    receiving = threading.Thread(target=rclpy.spin, args=(monitor,), daemon=True)
    receiving.start()
    try:
        while rclpy.ok():
            monitor.look()
            time.sleep(0)  # lets the other thread have a turn, and rests not at all
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
        receiving.join()


main()
