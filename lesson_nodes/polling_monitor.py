"""Report touches by polling: a while loop with a sleep checks for new ones.

Run it with ``python -m lesson_nodes.polling_monitor`` and end it with Ctrl-C.
"""

import math
import threading
import time
from collections import deque

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Int32

POLL_S = 0.05


class PollingMonitor(Node):
    """Stores received touches, and publishes their numbers when `look` is called.

    Topics:
        /monitor/by_polling (std_msgs/Int32): a touch's number.

    Subscriptions:
        /robot/touch (std_msgs/Int32): a touch's number.

    Parameters:
        poll_s (float): How long to sleep between two polls, in real seconds; with 0, it doesn't sleep.
        keep_all (bool): Whether to keep all touches until the next poll, instead of only the last one.

    Raises:
        ValueError: The time between two polls is negative or not finite.
    """

    def __init__(self) -> None:
        super().__init__("polling_monitor")
        self.poll_s = self.declare_parameter("poll_s", POLL_S).value
        keep_all = self.declare_parameter("keep_all", False).value
        if not 0.0 <= self.poll_s < math.inf:
            raise ValueError(
                f"The time between two polls must be finite and at least 0 s, not {self.poll_s}."
            )
        self.kept: deque[int] = deque(maxlen=None if keep_all else 1)
        self.report_publisher = self.create_publisher(Int32, "/monitor/by_polling", 100)
        self.create_subscription(Int32, "/robot/touch", self.keep, 100)

    def keep(self, message: Int32) -> None:
        """Store the touch. It replaces the previous one, unless all touches are kept."""
        self.kept.append(message.data)

    def look(self) -> None:
        """Publish the touches stored since the last poll."""
        while self.kept:
            self.report_publisher.publish(Int32(data=self.kept.popleft()))


def receive(executor: SingleThreadedExecutor) -> None:
    """Spin the executor in a second thread, so that its node receives touches while the loop runs."""
    try:
        executor.spin()
    except ExternalShutdownException:
        pass


def main(args: list[str] | None = None) -> None:
    """Poll until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    monitor = PollingMonitor()
    executor = SingleThreadedExecutor()
    executor.add_node(monitor)
    receiving = threading.Thread(target=receive, args=(executor,))
    receiving.start()
    try:
        while rclpy.ok():
            monitor.look()
            if monitor.poll_s > 0.0:
                time.sleep(monitor.poll_s)
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()
        receiving.join()


if __name__ == "__main__":
    main()
