# A script without a class and without NumPy: each angle goes a part of the way to what was measured.
import math

import rclpy
from rclpy.executors import ExternalShutdownException
from sensor_msgs.msg import JointState

PART = 0.25
angles = []
last = (0, 0)


def on_joints(message):
    global angles, last
    stamp = (message.header.stamp.sec, message.header.stamp.nanosec)
    if not angles or stamp < last:
        angles = list(message.position)
    last = stamp
    angles = [
        old if math.isnan(new) else old + PART * (new - old)
        for old, new in zip(angles, message.position)
    ]
    message.position = angles
    publisher.publish(message)


rclpy.init()
node = rclpy.create_node("exponential")
publisher = node.create_publisher(JointState, "/robot/joint_states", 10)
node.create_subscription(JointState, "/encoders/joint_states", on_joints, 100)
try:
    rclpy.spin(node)
except (KeyboardInterrupt, ExternalShutdownException):
    pass
