# loses: tilt_topic
# skips: tilt_count
# says: Float64
"""Float64 instead of Float32."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float64, String


class VitalSigns(Node):
    def __init__(self):
        super().__init__("vital_signs")
        self.level = 100.0
        self.heartbeat_pub = self.create_publisher(String, "/robot/heartbeat", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.tilt_pub = self.create_publisher(Float64, "/robot/tilt", 10)
        self.create_timer(1.0, self.publish_heartbeat)
        self.create_timer(2.0, self.publish_battery)
        self.create_timer(0.2, self.publish_tilt)

    def publish_heartbeat(self):
        self.heartbeat_pub.publish(String(data="alive"))

    def publish_battery(self):
        self.level = max(0.0, self.level - 0.2)
        self.battery_pub.publish(Float32(data=self.level))

    def publish_tilt(self):
        self.tilt_pub.publish(Float64(data=0.05))


def main():
    rclpy.init()
    try:
        rclpy.spin(VitalSigns())
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
