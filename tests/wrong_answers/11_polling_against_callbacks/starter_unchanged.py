# loses: none_missed, quick
# says: one variable that holds the last touch until somebody looks
"""A monitor that reports each touch of the hand."""

import threading
import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32


class TouchMonitor(Node):
    """Reports each touch of the hand.

    Topics:
        /monitor/seen (std_msgs/Int32): the number of the touch.

    Subscriptions:
        /robot/touch (std_msgs/Int32): the number of the touch.
    """

    def __init__(self) -> None:
        super().__init__("touch_monitor")
        self.seen_publisher = self.create_publisher(Int32, "/monitor/seen", 100)
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)
        self.last = 0  # the touch that came last
        self.reported = 0  # the touch that was reported last

    def on_touch(self, touch: Int32) -> None:
        """Keep the touch until somebody looks."""
        self.last = touch.data

    def look(self) -> None:
        """Report the last touch, if it is a new one."""
        if self.last != self.reported:
            self.reported = self.last
            self.seen_publisher.publish(Int32(data=self.reported))


def receive(monitor: TouchMonitor) -> None:
    """Let the monitor receive, in a thread beside the loop."""
    try:
        rclpy.spin(monitor)
    except ExternalShutdownException:
        pass


def main(args: list[str] | None = None) -> None:
    """Look again and again until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    monitor = TouchMonitor()
    receiving = threading.Thread(target=receive, args=(monitor,))
    receiving.start()
    try:
        while rclpy.ok():  # TODO: nobody should have to look
            monitor.look()
            time.sleep(0.2)
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
        receiving.join()


if __name__ == "__main__":
    main()
