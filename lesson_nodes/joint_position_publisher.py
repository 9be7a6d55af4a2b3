"""Simulate a humanoid that waves its left hand: publish the angles of its twelve joints, many times a second.

Run it with ``python -m lesson_nodes.joint_position_publisher`` and end it with Ctrl-C.
"""

import math

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32MultiArray

PERIOD_S = 0.05
WAVES_PER_SECOND = 0.8
JOINTS = (
    "neck",
    "waist",
    "left_shoulder",
    "left_elbow",
    "right_shoulder",
    "right_elbow",
    "left_hip",
    "left_knee",
    "left_ankle",
    "right_hip",
    "right_knee",
    "right_ankle",
)


def waving(seconds: float, waves_per_second: float = WAVES_PER_SECOND) -> list[float]:
    """Compute a waving robot's pose at a given time.

    Args:
        seconds: Time since any fixed moment, in seconds.
        waves_per_second: How many times per second the hand waves.

    Returns:
        12 angles in radians, in the order of JOINTS.
    """
    swing = math.sin(2.0 * math.pi * waves_per_second * seconds)
    sway = math.sin(0.5 * math.pi * waves_per_second * seconds)
    trunk = [0.12 + 0.06 * swing, 0.05 * sway]
    left_arm = [2.2, 0.45 + 0.5 * swing]
    right_arm = [0.25 + 0.04 * sway, -0.2]
    left_leg = [0.06, 0.06 + 0.03 * sway, 0.0]
    right_leg = [0.06, 0.06 - 0.03 * sway, 0.0]
    return [*trunk, *left_arm, *right_arm, *left_leg, *right_leg]


class JointPositionPublisher(Node):
    """Publishes the joint angles of a waving humanoid.

    Topics:
        /robot/joint_positions (std_msgs/Float32MultiArray): 12 angles in radians, in the order of JOINTS.

    Parameters:
        period_s (float): Time between two messages, in seconds.
        waves_per_second (float): How many times per second the hand waves, whatever the period.

    Set a parameter on the command line with ``--ros-args -p period_s:=0.5``. Its default is the argument of the
    same name.

    Args:
        period_s: Time between two messages, in seconds.
        waves_per_second: How many times per second the hand waves, whatever the period.

    Raises:
        ValueError: The period is not a positive number, or `waves_per_second` is negative or not finite.
    """

    def __init__(self, period_s: float = PERIOD_S, waves_per_second: float = WAVES_PER_SECOND) -> None:
        super().__init__("joint_position_publisher")
        period_s = self.declare_parameter("period_s", period_s).value
        if not 0.0 < period_s < math.inf:
            raise ValueError(
                f"The period is the time between two messages in seconds, for example 0.05, not {period_s}."
            )
        self.waves_per_second = self.declare_parameter("waves_per_second", waves_per_second).value
        if not 0.0 <= self.waves_per_second < math.inf:
            raise ValueError(
                f"A hand waves 0.0 times a second or more often, for example 0.8, not {self.waves_per_second}."
            )
        self.joint_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.joint_timer = self.create_timer(period_s, self.publish_joint_positions)
        self.get_logger().info("Joint position publisher started")

    def publish_joint_positions(self) -> None:
        """Publish the current joint angles."""
        seconds = self.get_clock().now().nanoseconds / 1e9
        self.joint_publisher.publish(Float32MultiArray(data=waving(seconds, self.waves_per_second)))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(JointPositionPublisher())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
