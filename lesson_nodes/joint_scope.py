"""Record one joint's angle, as measured by the encoders and as published by a filter.

Run it with ``python -m lesson_nodes.joint_scope`` and end it with Ctrl-C.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import JointState

JOINT = "left_elbow"


class JointScope(Node):
    """Records a joint's measured and filtered angles.

    Subscriptions:
        /encoders/joint_states (sensor_msgs/JointState): measured angles in radians.
        /robot/joint_states (sensor_msgs/JointState): filtered angles in radians.

    Attributes:
        measured: Pairs of a stamp (s) and the joint's measured angle (rad).
        filtered: Pairs of a stamp (s) and the joint's filtered angle (rad).

    Args:
        joint: The joint's name.
    """

    def __init__(self, joint: str = JOINT) -> None:
        super().__init__("joint_scope")
        self.joint = joint
        self.measured: list[tuple[float, float]] = []
        self.filtered: list[tuple[float, float]] = []
        self.create_subscription(JointState, "/encoders/joint_states", self.on_measured, 50)
        self.create_subscription(JointState, "/robot/joint_states", self.on_filtered, 50)

    def on_measured(self, message: JointState) -> None:
        """Record a measured angle."""
        self.measured.append(self.read(message))

    def on_filtered(self, message: JointState) -> None:
        """Record a filtered angle."""
        self.filtered.append(self.read(message))

    def read(self, message: JointState) -> tuple[float, float]:
        """Return a message's stamp (s) and the joint's angle (rad)."""
        stamp = message.header.stamp
        return stamp.sec + stamp.nanosec / 1e9, message.position[list(message.name).index(self.joint)]


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(JointScope())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
