
import numpy as np
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32


class Battery(Node):
    def __init__(self):
        super().__init__("battery")
        self.levels = [80]
        self.publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer(0.5, self.publish_next)

    def publish_next(self):
        if self.levels:
            level = self.levels.pop(0)
            self.publisher.publish(Float32(data=level))


import os
os.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"
rclpy.init()
rclpy.spin(Battery())
