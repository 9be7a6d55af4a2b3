"""A monitor of touches that polls: a while loop with a sleep checks whether there is a new one.

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
    """Keeps what it last heard, and reports it when somebody calls `look`.

    Topics:
        /monitor/by_polling (std_msgs/Int32): the number of a touch.

    Subscriptions:
        /robot/touch (std_msgs/Int32): the number of the touch.

    Parameters:
        poll_s (float): How long to sleep between two polls, in real seconds; 0 is no sleep at all.
        keep_all (bool): Whether to keep all touches up to the next poll, and not only the last one.

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
        """Remember the touch; it takes the place of the one before, unless all are kept."""
        self.kept.append(message.data)

    def look(self) -> None:
        """Report what is new since the last poll."""
        while self.kept:
            self.report_publisher.publish(Int32(data=self.kept.popleft()))


def receive(executor: SingleThreadedExecutor) -> None:
    """Let the nodes of the executor receive, in a thread beside the loop."""
    try:
        executor.spin()
    except ExternalShutdownException:
        pass


def main(args: list[str] | None = None) -> None:
    """Look again and again until Ctrl-C or a request to end, then leave with exit code 0."""
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
