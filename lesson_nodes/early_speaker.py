"""Simulate a robot that publishes all of its messages at the start, and none later.

Run it with ``python -m lesson_nodes.early_speaker`` and end it with Ctrl-C.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

WORDS = ("booting", "standing", "operational")


class EarlySpeaker(Node):
    """Publishes three states right away, and keeps the last `depth` of them for late subscriptions.

    Topics:
        /robot/status (std_msgs/String): "booting", "standing", "operational"; reliable, transient local.

    Parameters (each overrides the argument of the same name):
        depth: Number of messages to keep.
    """

    def __init__(self, depth: int = 1) -> None:
        super().__init__("early_speaker")
        depth = self.declare_parameter("depth", depth).value
        qos = QoSProfile(depth=depth, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.status_publisher = self.create_publisher(String, "/robot/status", qos)
        for word in WORDS:
            self.status_publisher.publish(String(data=word))
        self.get_logger().info("Early speaker started, and has said it all")


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(EarlySpeaker())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
