"""Simulate a humanoid that moves each arm with a separate timer: one arm many times a second, the other once.

Run it with ``python -m lesson_nodes.two_arms`` and end it with Ctrl-C.
"""

import math

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32MultiArray

LEFT_PERIOD_S = 0.05
RIGHT_PERIOD_S = 1.0
SWING_PERIOD_S = 3.5
JOINT_COUNT = 12
LEFT_SHOULDER, LEFT_ELBOW, RIGHT_SHOULDER, RIGHT_ELBOW = 2, 3, 4, 5


def lift(seconds: float) -> float:
    """Compute the angle of a shoulder that moves up and down, at a given time.

    Args:
        seconds: Time since any fixed moment, in seconds.

    Returns:
        The angle in radians: 0.3 when the arm is almost down, 2.3 when the hand is above the head.
    """
    return 1.3 - math.cos(2.0 * math.pi * seconds / SWING_PERIOD_S)


class TwoArms(Node):
    """Moves both arms up and down by the same function of time, each arm whenever its timer fires.

    Topics:
        /robot/joint_positions (std_msgs/Float32MultiArray): 12 angles in radians, published after each change.

    Parameters:
        left_period_s (float): Time between two steps of the left arm, in seconds.
        right_period_s (float): Time between two steps of the right arm, in seconds.

    Raises:
        ValueError: A period is not a positive number.
    """

    def __init__(self) -> None:
        super().__init__("two_arms")
        left_period_s = self.declare_parameter("left_period_s", LEFT_PERIOD_S).value
        right_period_s = self.declare_parameter("right_period_s", RIGHT_PERIOD_S).value
        for period_s in (left_period_s, right_period_s):
            if not 0.0 < period_s < math.inf:
                raise ValueError(
                    f"A period is the time between two steps in seconds, for example 0.05, not {period_s}."
                )
        self.angles = [0.0] * JOINT_COUNT
        self.angles[LEFT_ELBOW] = self.angles[RIGHT_ELBOW] = 0.25
        self.angles[LEFT_SHOULDER] = self.angles[RIGHT_SHOULDER] = lift(0.0)
        self.start_s = self.seconds()
        self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.left_timer = self.create_timer(left_period_s, self.move_left)
        self.right_timer = self.create_timer(right_period_s, self.move_right)

    def seconds(self) -> float:
        """Return the time of the node's clock, in seconds."""
        return self.get_clock().now().nanoseconds / 1e9

    def move_left(self) -> None:
        """Move the left arm to its angle for the current time."""
        self.angles[LEFT_SHOULDER] = lift(self.seconds() - self.start_s)
        self.joint_publisher.publish(Float32MultiArray(data=self.angles))

    def move_right(self) -> None:
        """Move the right arm to its angle for the current time."""
        self.angles[RIGHT_SHOULDER] = lift(self.seconds() - self.start_s)
        self.joint_publisher.publish(Float32MultiArray(data=self.angles))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(TwoArms())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
