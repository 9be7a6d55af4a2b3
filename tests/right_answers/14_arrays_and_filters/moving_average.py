"""NumPy only: the mean of the last seven messages."""

from collections import deque

import numpy as np
import rclpy
from rclpy.node import Node
from sensor_msgs.msg import JointState

WINDOW = 7


class Smoother(Node):
    def __init__(self):
        super().__init__("smoother")
        self.window = deque(maxlen=WINDOW)
        self.newest_s = None
        self.out = self.create_publisher(JointState, "/robot/joint_states", 10)
        self.create_subscription(JointState, "/encoders/joint_states", self.smooth, 10)

    def smooth(self, message):
        now_s = message.header.stamp.sec + message.header.stamp.nanosec / 1e9
        angles = np.asarray(message.position)
        if self.newest_s is None or now_s < self.newest_s:
            self.window.extend([angles] * WINDOW)
        self.newest_s = now_s
        self.window.append(np.where(np.isnan(angles), self.window[-1], angles))
        answer = JointState(header=message.header, name=message.name)
        answer.position = np.mean(self.window, axis=0).tolist()
        self.out.publish(answer)


def main():
    rclpy.init()
    rclpy.spin(Smoother())


main()
