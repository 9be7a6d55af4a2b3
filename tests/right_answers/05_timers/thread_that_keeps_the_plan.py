"""A thread on the wall clock that sleeps until the next moment of a fixed plan: no timer, and no drift either."""

import threading
import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String


class VitalSigns(Node):
    def __init__(self):
        super().__init__("vital_signs")
        self.heartbeat = self.create_publisher(String, "/robot/heartbeat", 10)
        self.battery = self.create_publisher(Float32, "/robot/battery", 10)
        self.tilt = self.create_publisher(Float32, "/robot/tilt", 10)
        threading.Thread(target=self.work, daemon=True).start()

    def work(self):
        start, tick = time.monotonic(), 0
        while rclpy.ok():
            tick += 1
            time.sleep(max(0.0, start + 0.2 * tick - time.monotonic()))
            self.tilt.publish(Float32(data=0.0))
            if tick % 5 == 0:
                self.heartbeat.publish(String(data="alive"))
            if tick % 10 == 0:
                self.battery.publish(Float32(data=90.0))


rclpy.init()
rclpy.spin(VitalSigns())
