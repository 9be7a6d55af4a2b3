"""Report each touch of a robot's hand from a subscription callback.

Run it with ``python -m lesson_nodes.callback_monitor`` and end it with Ctrl-C.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Int32


class CallbackMonitor(Node):
    """Publishes each touch's number as soon as the touch is received.

    Topics:
        /monitor/by_callback (std_msgs/Int32): the touch's number.

    Subscriptions:
        /robot/touch (std_msgs/Int32): the touch's number.
    """

    def __init__(self) -> None:
        super().__init__("callback_monitor")
        self.report_publisher = self.create_publisher(Int32, "/monitor/by_callback", 100)
        self.create_subscription(Int32, "/robot/touch", self.on_touch, 100)

    def on_touch(self, message: Int32) -> None:
        """Publish the touch's number."""
        self.report_publisher.publish(Int32(data=message.data))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(CallbackMonitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
