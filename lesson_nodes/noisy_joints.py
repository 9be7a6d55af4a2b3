"""Simulate a waving humanoid's encoders: publish noisy measurements of its twelve joint angles.

Run it with ``python -m lesson_nodes.noisy_joints`` and end it with Ctrl-C.
"""

import math
import random

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import JointState
from std_msgs.msg import Float32MultiArray

from lesson_nodes.joint_position_publisher import JOINTS, waving

PERIOD_S = 0.05
NOISE_RAD = 0.05
WAVES_PER_SECOND = 0.2
SEED = 14


class NoisyJoints(Node):
    """Publishes joint angles as noisy encoders measure them. Every run with the same seed has the same noise.

    Topics:
        /encoders/joint_states (sensor_msgs/JointState): names and angles (rad), stamped with the time since the start.
        /robot/joint_positions (std_msgs/Float32MultiArray): the same angles, for the figure on the screen.

    Parameters:
        period_s (float): Time between two messages, in seconds.
        noise_rad (float): Standard deviation of the noise, in radians.
        seed (int): Seed of the noise.

    Raises:
        ValueError: The period is not a positive number, or the noise is negative.
    """

    def __init__(self, period_s: float = PERIOD_S, noise_rad: float = NOISE_RAD, seed: int = SEED) -> None:
        super().__init__("noisy_joints")
        self.period_s = self.declare_parameter("period_s", period_s).value
        if not 0.0 < self.period_s < math.inf:
            raise ValueError(
                f"The period is the time between two messages in seconds, for example 0.05, not {self.period_s}."
            )
        self.noise_rad = self.declare_parameter("noise_rad", noise_rad).value
        if not 0.0 <= self.noise_rad < math.inf:
            raise ValueError(f"The noise is 0.0 rad or more, for example 0.05, not {self.noise_rad}.")
        self.dice = random.Random(self.declare_parameter("seed", seed).value)
        self.count = 0
        self.encoder_publisher = self.create_publisher(JointState, "/encoders/joint_states", 50)
        self.figure_publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 50)
        self.timer = self.create_timer(self.period_s, self.publish_angles)

    def publish_angles(self) -> None:
        """Measure all joints once, and publish the angles with the time of the measurement."""
        seconds = self.count * self.period_s
        self.count += 1
        angles = [angle + self.dice.gauss(0.0, self.noise_rad) for angle in waving(seconds, WAVES_PER_SECOND)]
        message = JointState(name=list(JOINTS), position=angles)
        message.header.stamp.sec = int(seconds)
        message.header.stamp.nanosec = round(seconds % 1.0 * 1e9)
        self.encoder_publisher.publish(message)
        self.figure_publisher.publish(Float32MultiArray(data=angles))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(NoisyJoints())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
