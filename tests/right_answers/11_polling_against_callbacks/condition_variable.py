"""The loop is still there, but it waits until the callback notifies it."""

import threading
from collections import deque

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32


class TouchMonitor(Node):
    def __init__(self):
        super().__init__("touch_monitor")
        self.seen = self.create_publisher(Int32, "/monitor/seen", 100)
        self.touches = deque()
        self.news = threading.Condition()
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)

    def on_touch(self, touch):
        with self.news:
            self.touches.append(touch.data)
            self.news.notify()

    def look(self):
        with self.news:
            self.news.wait_for(lambda: self.touches, timeout=1.0)
            while self.touches:
                self.seen.publish(Int32(data=self.touches.popleft()))


def receive(monitor):
    try:
        rclpy.spin(monitor)
    except ExternalShutdownException:
        pass


def main():
    rclpy.init()
    monitor = TouchMonitor()
    receiving = threading.Thread(target=receive, args=(monitor,), daemon=True)
    receiving.start()
    try:
        while rclpy.ok():
            monitor.look()
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
        receiving.join()


main()
