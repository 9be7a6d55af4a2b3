"""An alpha-beta tracker in plain Python, in a loop of spin_once."""

import math

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import JointState

ALPHA, BETA, DT = 0.25, 0.03, 0.05


class Joint:
    def __init__(self, angle):
        self.angle, self.speed = angle, 0.0

    def update(self, measured):
        self.angle += self.speed * DT
        if not math.isnan(measured):
            error = measured - self.angle
            self.angle += ALPHA * error
            self.speed += BETA / DT * error
        return self.angle


class Tracker(Node):
    def __init__(self):
        super().__init__("tracker")
        self.joints = []
        self.last = None
        self.pub = self.create_publisher(JointState, "/robot/joint_states", 20)
        self.sub = self.create_subscription(JointState, "/encoders/joint_states", self.cb, 20)

    def cb(self, msg):
        now = msg.header.stamp.sec + msg.header.stamp.nanosec * 1e-9
        if self.last is None or now < self.last:
            self.joints = [Joint(angle) for angle in msg.position]
        self.last = now
        out = JointState()
        out.header.stamp = msg.header.stamp
        out.name = list(msg.name)
        out.position = [joint.update(angle) for joint, angle in zip(self.joints, msg.position)]
        self.pub.publish(out)


rclpy.init()
tracker = Tracker()
try:
    while rclpy.ok():
        rclpy.spin_once(tracker, timeout_sec=0.5)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
