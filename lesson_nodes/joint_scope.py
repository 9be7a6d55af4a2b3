"""Writes down the angle of one joint, as the encoders measure it and as a filter publishes it.

Run it with ``python -m lesson_nodes.joint_scope`` and end it with Ctrl-C.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import JointState

JOINT = "left_elbow"


class JointScope(Node):
    """Listens to the encoders and to a filter.

    Subscriptions:
        /encoders/joint_states (sensor_msgs/JointState): angles in radians, as they are measured.
        /robot/joint_states (sensor_msgs/JointState): angles in radians, filtered.

    Attributes:
        measured: Pairs of a stamp (s) and the angle of the joint (rad), as the encoders say it.
        filtered: The same, as the filter says it.

    Args:
        joint: The name of the joint.
    """

    def __init__(self, joint: str = JOINT) -> None:
        super().__init__("joint_scope")
        self.joint = joint
        self.measured: list[tuple[float, float]] = []
        self.filtered: list[tuple[float, float]] = []
        self.create_subscription(JointState, "/encoders/joint_states", self.on_measured, 50)
        self.create_subscription(JointState, "/robot/joint_states", self.on_filtered, 50)

    def on_measured(self, message: JointState) -> None:
        """Write down what the encoders say."""
        self.measured.append(self.read(message))

    def on_filtered(self, message: JointState) -> None:
        """Write down what the filter says."""
        self.filtered.append(self.read(message))

    def read(self, message: JointState) -> tuple[float, float]:
        """The stamp of a message (s), and the angle of the joint (rad)."""
        stamp = message.header.stamp
        return stamp.sec + stamp.nanosec / 1e9, message.position[list(message.name).index(self.joint)]


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(JointScope())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
