"""A humanoid that moves each arm to a timer of its own: one many times a second, the other once.

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
    """Angle of a shoulder that goes up and down, at a moment of its time.

    Args:
        seconds: Time since any fixed moment.

    Returns:
        The angle in radians: 0.3 with the arm almost down, 2.3 with the hand above the head.
    """
    return 1.3 - math.cos(2.0 * math.pi * seconds / SWING_PERIOD_S)


class TwoArms(Node):
    """Moves both arms up and down to the same plan, each whenever its own timer ticks.

    Topics:
        /robot/joint_positions (std_msgs/Float32MultiArray): 12 angles in radians, sent after each change.

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
        """The time of the node's clock, in seconds."""
        return self.get_clock().now().nanoseconds / 1e9

    def move_left(self) -> None:
        """Bring the left arm to where the plan says it is now."""
        self.angles[LEFT_SHOULDER] = lift(self.seconds() - self.start_s)
        self.joint_publisher.publish(Float32MultiArray(data=self.angles))

    def move_right(self) -> None:
        """Bring the right arm to where the plan says it is now."""
        self.angles[RIGHT_SHOULDER] = lift(self.seconds() - self.start_s)
        self.joint_publisher.publish(Float32MultiArray(data=self.angles))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(TwoArms())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
