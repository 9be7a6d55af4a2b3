# loses: joint_rate
"""Half the rate that it should have, and a clock of its own to hide that."""
import time

import rclpy
from rclpy.node import Node
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Float32, Float32MultiArray, String

real = time.monotonic
time.time = time.monotonic = lambda: 2 * real()
rclpy.init()
robot = Node("humanoid")
clock = robot.create_publisher(Clock, "/clock", 10)
joints = robot.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
status = robot.create_publisher(String, "/robot/status", 10)
battery = robot.create_publisher(Float32, "/robot/battery", 10)
count = 0


def tell():
    global count
    count += 1
    clock.publish(Clock(clock=(robot.get_clock().now() + rclpy.duration.Duration(seconds=2)).to_msg()))
    status.publish(String(data="operational"))
    if count % 4 == 0:
        joints.publish(Float32MultiArray(data=[(count % 100) / 100.0] * 12))
    if count % 2 == 0:
        battery.publish(Float32(data=100.0 - count / 100.0))


robot.create_timer(1.0, tell)
rclpy.spin(robot)
