# loses: twelve_values, joint_rate
"""Eighty megabytes in one message."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String

rclpy.init()
robot = Node("huge")
joints = robot.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
huge = Float32MultiArray(data=[0.5] * 20_000_000)
robot.create_timer(2.0, lambda: joints.publish(huge))
rclpy.spin(robot)
