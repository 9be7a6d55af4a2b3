"""Publish ten pings per second. `workbook doctor` runs this program to test communication between processes."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class PingPublisher(Node):
    """Publishes numbered pings on /doctor/ping."""

    def __init__(self) -> None:
        super().__init__("ping_publisher")
        self._count = 0
        self._publisher = self.create_publisher(String, "/doctor/ping", 10)
        self.create_timer(0.1, self._ping)

    def _ping(self) -> None:
        self._count += 1
        self._publisher.publish(String(data=f"ping {self._count}"))


def main() -> None:
    """Publish until interrupted."""
    try:
        rclpy.init()
        rclpy.spin(PingPublisher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
