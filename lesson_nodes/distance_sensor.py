"""Simulate the distance sensor of a robot that walks to a wall and back, again and again.

Run it with ``python -m lesson_nodes.distance_sensor`` and end it with Ctrl-C.
"""

import math

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32

PERIOD_S = 0.05
FAR_M = 2.0
NEAR_M = 0.2
WALK_S = 5.0


def distance_to_the_wall(seconds: float) -> float:
    """Compute the distance to the wall at a given time.

    Args:
        seconds: Time in seconds since the robot started to walk, 2.0 m from the wall.

    Returns:
        The distance in meters: 2.0 at the start, 0.2 after 2.5 s, and 2.0 again after 5 s.
    """
    part = seconds / WALK_S % 1.0
    return FAR_M - (FAR_M - NEAR_M) * (1.0 - abs(1.0 - 2.0 * part))


class DistanceSensor(Node):
    """Publishes the simulated distance from the robot to the wall.

    Topics:
        /robot/distance (std_msgs/Float32): distance in meters, 0.2 to 2.0.

    Parameters:
        period_s (float): Time between two messages, in seconds.

    Raises:
        ValueError: The period is not a positive number.
    """

    def __init__(self) -> None:
        super().__init__("distance_sensor")
        period_s = self.declare_parameter("period_s", PERIOD_S).value
        if not 0.0 < period_s < math.inf:
            raise ValueError(
                f"The period is the time between two messages in seconds, for example 0.05, not {period_s}."
            )
        self.start_s = self.seconds()
        self.distance_publisher = self.create_publisher(Float32, "/robot/distance", 100)
        self.timer = self.create_timer(period_s, self.publish_distance)

    def seconds(self) -> float:
        """Return the time of the node's clock, in seconds."""
        return self.get_clock().now().nanoseconds / 1e9

    def publish_distance(self) -> None:
        """Measure the distance once, and publish it."""
        distance_m = distance_to_the_wall(self.seconds() - self.start_s)
        self.distance_publisher.publish(Float32(data=distance_m))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(DistanceSensor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
