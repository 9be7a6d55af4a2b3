"""One small filter object for each joint, found by the joint's name. The node stands alone: no main()."""

from math import isfinite

from rclpy.node import Node
from sensor_msgs.msg import JointState


class TwoStages:
    """Two exponential filters, one behind the other."""

    def __init__(self, angle: float) -> None:
        self.first = self.second = angle

    def __call__(self, angle: float) -> float:
        if isfinite(angle):
            self.first += 0.4 * (angle - self.first)
        self.second += 0.4 * (self.first - self.second)
        return self.second


class EncoderFilter(Node):
    def __init__(self) -> None:
        super().__init__("encoder_filter", namespace="robot")
        self.filters: dict[str, TwoStages] = {}
        self.switched_on_ns = 0
        self.pub = self.create_publisher(JointState, "joint_states", 20)
        self.create_subscription(JointState, "/encoders/joint_states", self.on_message, 20)

    def on_message(self, message: JointState) -> None:
        on_ns = message.header.stamp.sec * 10**9 + message.header.stamp.nanosec
        if on_ns < self.switched_on_ns:
            self.filters.clear()
        self.switched_on_ns = on_ns
        filtered = []
        for name, angle in zip(message.name, message.position):
            if name not in self.filters:
                self.filters[name] = TwoStages(angle)
            filtered.append(self.filters[name](angle))
        self.pub.publish(JointState(header=message.header, name=message.name, position=filtered))
