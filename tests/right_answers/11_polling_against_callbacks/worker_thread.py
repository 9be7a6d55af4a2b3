"""The callback puts the number into a queue; a thread that waits in get() reports it."""

import queue
import threading

import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32


class TouchMonitor(Node):
    def __init__(self):
        super().__init__("touch_monitor")
        self.seen = self.create_publisher(Int32, "/monitor/seen", 100)
        self.touches = queue.Queue()
        threading.Thread(target=self.work, daemon=True).start()
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)

    def on_touch(self, touch):
        self.touches.put(touch.data)

    def work(self):
        while True:
            self.seen.publish(Int32(data=self.touches.get()))


def main():
    rclpy.init()
    try:
        rclpy.spin(TouchMonitor())
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


main()
