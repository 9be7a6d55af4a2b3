"""A monitor of touches that is called for each of them.

Run it with ``python -m lesson_nodes.callback_monitor`` and end it with Ctrl-C.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32


class CallbackMonitor(Node):
    """Reports each touch as soon as it hears of it.

    Topics:
        /monitor/by_callback (std_msgs/Int32): the number of the touch.

    Subscriptions:
        /robot/touch (std_msgs/Int32): the number of the touch.
    """

    def __init__(self) -> None:
        super().__init__("callback_monitor")
        self.report_publisher = self.create_publisher(Int32, "/monitor/by_callback", 100)
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)

    def on_touch(self, message: Int32) -> None:
        """Report the touch."""
        self.report_publisher.publish(Int32(data=message.data))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(CallbackMonitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
