"""The rates are written in hertz, and one divided by them is the period."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String

RATES_HZ = {"heartbeat": 1.0, "battery": 0.5, "tilt": 5.0}


class VitalSigns(Node):
    def __init__(self):
        super().__init__("vital_signs")
        self.level = 100.0
        self.heartbeat_pub = self.create_publisher(String, "/robot/heartbeat", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.tilt_pub = self.create_publisher(Float32, "/robot/tilt", 10)
        for what, hz in RATES_HZ.items():
            self.create_timer(1.0 / hz, getattr(self, f"publish_{what}"))

    def publish_heartbeat(self):
        self.heartbeat_pub.publish(String(data="alive"))

    def publish_battery(self):
        self.level = max(0.0, self.level - 0.2)
        self.battery_pub.publish(Float32(data=self.level))

    def publish_tilt(self):
        self.tilt_pub.publish(Float32(data=0.05))


def main():
    rclpy.init()
    try:
        rclpy.spin(VitalSigns())
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
