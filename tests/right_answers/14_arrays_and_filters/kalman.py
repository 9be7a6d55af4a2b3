"""A Kalman filter for each joint, all at once: what moves is an angle and its speed."""

import numpy as np
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import JointState

STEP_S = 0.05
MOVE = np.array([[1.0, STEP_S], [0.0, 1.0]])
PUSHED = 0.6**2 * np.array([[STEP_S**4 / 4, STEP_S**3 / 2], [STEP_S**3 / 2, STEP_S**2]])
MEASURED = 0.02**2


class Kalman(Node):
    def __init__(self):
        super().__init__("kalman")
        self.state = None  # angles and speeds, 2 x 12
        self.doubt = None  # 12 x 2 x 2
        self.last_ns = 0
        self.answers = self.create_publisher(JointState, "/robot/joint_states", 10)
        self.create_subscription(JointState, "/encoders/joint_states", self.heard, 10)

    def heard(self, message):
        ns = message.header.stamp.sec * 1_000_000_000 + message.header.stamp.nanosec
        angles = np.array(message.position)
        if self.state is None or ns < self.last_ns:
            self.state = np.vstack([angles, np.zeros_like(angles)])
            self.doubt = np.tile(np.diag([MEASURED, 0.01]), (len(angles), 1, 1))
        self.last_ns = ns
        self.state = MOVE @ self.state
        self.doubt = MOVE @ self.doubt @ MOVE.T + PUSHED
        seen = np.isfinite(angles)
        gain = self.doubt[:, :, 0] / (self.doubt[:, 0, 0] + MEASURED)[:, None]
        gain[~seen] = 0.0
        surprise = np.where(seen, angles - self.state[0], 0.0)
        self.state = self.state + (gain * surprise[:, None]).T
        self.doubt = self.doubt - gain[:, :, None] * self.doubt[:, None, 0, :]
        self.answers.publish(
            JointState(header=message.header, name=message.name, position=self.state[0].tolist())
        )


def main():
    rclpy.init()
    rclpy.spin(Kalman())
