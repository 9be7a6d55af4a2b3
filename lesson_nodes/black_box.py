"""Simulate a robot's black box: store each message from the distance sensor, and publish their number.

Run it with ``python -m lesson_nodes.black_box`` and end it with Ctrl-C.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, Int32

REPORT_PERIOD_S = 0.2


class BlackBox(Node):
    """Stores every distance that it receives.

    Subscriptions:
        /robot/distance (std_msgs/Float32): distance in meters.

    Topics:
        /black_box/kept (std_msgs/Int32), 5 Hz: number of distances stored so far.

    Attributes:
        kept: The stored distances in meters, in order of arrival.
    """

    def __init__(self) -> None:
        super().__init__("black_box")
        self.kept: list[float] = []
        self.create_subscription(Float32, "/robot/distance", self.on_distance, 100)
        self.kept_publisher = self.create_publisher(Int32, "/black_box/kept", 10)
        self.create_timer(REPORT_PERIOD_S, self.report)

    def on_distance(self, message: Float32) -> None:
        """Store a distance."""
        self.kept.append(message.data)

    def report(self) -> None:
        """Publish the number of stored distances."""
        self.kept_publisher.publish(Int32(data=len(self.kept)))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(BlackBox())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
