"""A low-pass filter without feedback, designed by SciPy, with the memory that lfilter hands back."""

import array

import numpy as np
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from scipy import signal
from sensor_msgs.msg import JointState

TAPS = signal.firwin(9, 1.5, fs=20.0)


class Memory:
    """What the node remembers; made anew at each start of the board."""

    def __init__(self, angles: np.ndarray) -> None:
        self.good = angles
        self.state = np.outer(signal.lfilter_zi(TAPS, 1.0), angles)

    def next(self, angles: np.ndarray) -> np.ndarray:
        self.good = np.where(np.isnan(angles), self.good, angles)
        filtered, self.state = signal.lfilter(TAPS, 1.0, [self.good], axis=0, zi=self.state)
        return filtered[0]


class Filter(Node):
    def __init__(self) -> None:
        super().__init__("filter")
        self.memory: Memory | None = None
        self.before = -1.0
        self.pub = self.create_publisher(JointState, "/robot/joint_states", 10)
        self.sub = self.create_subscription(JointState, "/encoders/joint_states", self.on_message, 10)

    def on_message(self, message: JointState) -> None:
        angles = np.frombuffer(message.position)
        stamp = message.header.stamp
        seconds = stamp.sec + stamp.nanosec * 1e-9
        if self.memory is None or seconds < self.before:
            self.get_logger().info("begin anew")
            self.memory = Memory(angles)
        self.before = seconds
        message.position = array.array("d", self.memory.next(angles).tobytes())
        self.pub.publish(message)


def main() -> None:
    rclpy.init()
    try:
        rclpy.spin(Filter())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == "__main__":
    main()
