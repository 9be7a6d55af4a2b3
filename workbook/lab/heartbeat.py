"""The program that `workbook doctor` starts to hear from another process: beats on /doctor/beat, ten a second."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class Heartbeat(Node):
    """Publishes a word and a number."""

    def __init__(self) -> None:
        super().__init__("heartbeat")
        self._beats = 0
        self._publisher = self.create_publisher(String, "/doctor/beat", 10)
        self.create_timer(0.1, self._beat)

    def _beat(self) -> None:
        self._beats += 1
        self._publisher.publish(String(data=f"beat {self._beats}"))


def main() -> None:
    """Beat until interrupted."""
    try:
        rclpy.init()
        rclpy.spin(Heartbeat())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
