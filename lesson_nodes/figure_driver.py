"""Drive a small robot along a circle or a figure eight, with velocity commands.

Run it with ``python -m lesson_nodes.figure_driver`` and end it with Ctrl-C. Steer with
``--ros-args -p forward_mps:=0.4 -p turn_radps:=1.0 -p eight:=true``.
"""

import math

import rclpy
from geometry_msgs.msg import Twist
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node

PERIOD_S = 0.1


class FigureDriver(Node):
    """Publishes ten times a second how fast the robot should drive and turn.

    Topics:
        /robot/cmd_vel (geometry_msgs/Twist), 10 Hz: linear.x in m/s, angular.z in rad/s (positive: to the left).

    Parameters:
        forward_mps: Forward speed in m/s; with a negative value, the robot drives backward.
        turn_radps: Turning rate in rad/s; with 0.0, the robot drives straight.
        eight: Whether to reverse the turning direction after each full circle.

    Raises:
        ValueError: A parameter is not finite.
    """

    def __init__(self) -> None:
        super().__init__("figure_driver")
        self.forward_mps = self.finite("forward_mps", 0.4)
        self.turn_radps = self.finite("turn_radps", 1.0)
        self.eight = bool(self.declare_parameter("eight", True).value)
        self.turned_rad = 0.0
        self.command_publisher = self.create_publisher(Twist, "/robot/cmd_vel", 10)
        self.create_timer(PERIOD_S, self.publish_command)

    def finite(self, name: str, default: float) -> float:
        """Declare a parameter, and return its value. Raise ValueError if it isn't finite."""
        value = float(self.declare_parameter(name, default).value)
        if not math.isfinite(value):
            raise ValueError(f"{name} must be a finite number, not {value}")
        return value

    def publish_command(self) -> None:
        """Publish the speeds for the next tenth of a second."""
        circles = int((abs(self.turned_rad) + 1e-9) / (2.0 * math.pi))
        side = -1.0 if self.eight and circles % 2 else 1.0
        command = Twist()
        command.linear.x = self.forward_mps
        command.angular.z = side * self.turn_radps
        self.turned_rad += abs(self.turn_radps) * PERIOD_S
        self.command_publisher.publish(command)


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(FigureDriver())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
