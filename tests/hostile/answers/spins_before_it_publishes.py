# score: 0
# says: A call to spin returns only when ROS is shut down
"""In a notebook: the cell that spins stands above the one that publishes."""
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32MultiArray

rclpy.init()
robot = Node("humanoid")
rclpy.spin(robot)

joints = robot.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
robot.create_timer(2.0, lambda: joints.publish(Float32MultiArray(data=[0.0] * 12)))
rclpy.spin(robot)
