# score: 3
# says: could not be decoded
"""Bytes that are no message, on all three topics."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String

rclpy.init()
robot = Node("garbage")
out = [
    robot.create_publisher(Float32MultiArray, "/robot/joint_positions", 10),
    robot.create_publisher(Float32, "/robot/battery", 10),
    robot.create_publisher(String, "/robot/status", 10),
]


def send():
    for publisher in out:
        publisher.publish(b"\x00\x01\x00\x00\xff\xff\xff\x7f")
        publisher.publish(b"\x00")
        publisher.publish(b"")


robot.create_timer(0.5, send)
rclpy.spin(robot)
