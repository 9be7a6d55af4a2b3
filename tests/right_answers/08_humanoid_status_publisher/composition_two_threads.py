"""A robot that has a node instead of being one, on an executor with two threads."""

import random

import rclpy
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from std_msgs.msg import Float32, String


class Humanoid:
    def __init__(self):
        self.charge = 100.0
        self.node = rclpy.create_node("humanoid", namespace="robot")
        self.status = self.node.create_publisher(String, "status", 10)
        self.battery = self.node.create_publisher(Float32, "battery", 10)
        self.node.create_timer(1 / 1.0, self.say_status)
        self.node.create_timer(1 / 0.5, self.say_charge)

    def say_status(self):
        self.status.publish(String(data="operational" if self.charge else "error"))

    def say_charge(self):
        self.charge = max(self.charge - random.uniform(8.0, 12.0), 0.0)
        self.battery.publish(Float32(data=self.charge))


rclpy.init()
humanoid = Humanoid()
executor = MultiThreadedExecutor(num_threads=2)
executor.add_node(humanoid.node)
try:
    executor.spin()
except (KeyboardInterrupt, ExternalShutdownException):
    pass
finally:
    executor.shutdown()
    rclpy.try_shutdown()
