"""Report a battery's charge with a class: the node's attributes hold the state.

Run it with ``python -m lesson_nodes.battery_class`` and end it with Ctrl-C.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32

PERIOD_S = 2.0


class BatteryReport(Node):
    """Publishes a simulated battery's charge.

    Topics:
        /robot/battery (std_msgs/Float32), 0.5 Hz: charge in percent.
    """

    def __init__(self) -> None:
        super().__init__("battery_class")
        self.level = 100.0
        self.publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer(PERIOD_S, self.send)

    def send(self) -> None:
        """Drain the simulated battery a little, and publish the remaining charge."""
        self.level = max(0.0, self.level - 0.5)
        self.publisher.publish(Float32(data=self.level))


def main() -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init()
    try:
        rclpy.spin(BatteryReport())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
