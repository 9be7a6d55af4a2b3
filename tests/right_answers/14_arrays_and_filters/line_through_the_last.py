"""Savitzky-Golay: a straight line through the last 19 messages, and its end. It has no delay on a line at all."""

import numpy as np
import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.time import Time
from scipy.signal import savgol_coeffs
from sensor_msgs.msg import JointState

LENGTH = 19
WEIGHTS = savgol_coeffs(LENGTH, polyorder=1, pos=LENGTH - 1, use="dot")


class LineFilter(Node):
    def __init__(self) -> None:
        super().__init__("line_filter")
        self.history = np.empty((0, 0))
        self.last = None
        self.publisher_ = self.create_publisher(JointState, "/robot/joint_states", 10)
        self.subscription = self.create_subscription(
            JointState, "/encoders/joint_states", self.listener_callback, 10
        )

    def listener_callback(self, msg: JointState) -> None:
        measured = np.array(msg.position, dtype=np.float64)
        stamp = Time.from_msg(msg.header.stamp)
        if self.last is None or stamp < self.last:
            self.history = np.tile(measured, (LENGTH, 1))
        self.last = stamp
        bad = ~np.isfinite(measured)
        measured[bad] = self.history[-1, bad]
        self.history = np.vstack([self.history[1:], measured])
        out = JointState()
        out.header = msg.header
        out.name = msg.name
        out.position = (WEIGHTS @ self.history).tolist()
        self.publisher_.publish(out)


def main(args=None) -> None:
    rclpy.init(args=args)
    executor = SingleThreadedExecutor()
    executor.add_node(LineFilter())
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == "__main__":
    main()
