"""One timer at 5 Hz serves all three topics."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String


class VitalSigns(Node):
    def __init__(self):
        super().__init__("vital_signs")
        self.heartbeat = self.create_publisher(String, "/robot/heartbeat", 10)
        self.battery = self.create_publisher(Float32, "/robot/battery", 10)
        self.tilt = self.create_publisher(Float32, "/robot/tilt", 10)
        self.ticks = 0
        self.create_timer(0.2, self.tick)

    def tick(self):
        self.ticks += 1
        self.tilt.publish(Float32(data=0.01 * (self.ticks % 7)))
        if self.ticks % 5 == 0:
            self.heartbeat.publish(String(data=f"beat {self.ticks // 5}"))
        if self.ticks % 10 == 0:
            self.battery.publish(Float32(data=80.0))


rclpy.init()
rclpy.spin(VitalSigns())
