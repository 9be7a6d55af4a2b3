# loses: quick
# says: A queue that is emptied with each look loses nothing, but is just as late
"""All touches are kept, and reported five times a second."""

import threading
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class TouchMonitor(Node):
    def __init__(self):
        super().__init__("touch_monitor")
        self.seen = self.create_publisher(Int32, "/monitor/seen", 100)
        self.touches = []
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)

    def on_touch(self, touch):
        self.touches.append(touch.data)

    def look(self):
        while self.touches:
            self.seen.publish(Int32(data=self.touches.pop(0)))


def main():
    rclpy.init()
    monitor = TouchMonitor()
    receiving = threading.Thread(target=rclpy.spin, args=(monitor,), daemon=True)
    receiving.start()
    try:
        while rclpy.ok():
            monitor.look()
            time.sleep(0.2)
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
        receiving.join()


main()
