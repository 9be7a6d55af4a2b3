import rclpy
from lesson_nodes.humanoid_status_publisher import HumanoidStatusPublisher

rclpy.init()
rclpy.spin(HumanoidStatusPublisher(battery_level=10.0))
