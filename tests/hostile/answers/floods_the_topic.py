# loses: joint_rate
"""Right values, as fast as it can for two seconds, and then still hundreds a second."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String

import threading
import time

rclpy.init()
robot = Node("flood")
joints = robot.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)


def flood():
    count = 0
    began = time.monotonic()
    while rclpy.ok():
        if time.monotonic() > began + 2.0:
            time.sleep(0.003)
        count += 1
        joints.publish(Float32MultiArray(data=[(count % 100) / 100.0] * 12))


threading.Thread(target=flood, daemon=True).start()
rclpy.spin(robot)
