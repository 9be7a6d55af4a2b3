# loses: battery_count, tilt_count
# says: 1 Hz
# says: too fast by a factor of 2
"""One timer at 1 Hz does everything."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String


class VitalSigns(Node):
    def __init__(self):
        super().__init__("vital_signs")
        self.level = 100.0
        self.heartbeat_pub = self.create_publisher(String, "/robot/heartbeat", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.tilt_pub = self.create_publisher(Float32, "/robot/tilt", 10)
        self.create_timer(1.0, self.publish_all)

    def publish_heartbeat(self):
        self.heartbeat_pub.publish(String(data="alive"))

    def publish_battery(self):
        self.level = max(0.0, self.level - 0.2)
        self.battery_pub.publish(Float32(data=self.level))

    def publish_tilt(self):
        self.tilt_pub.publish(Float32(data=0.05))

    def publish_all(self):
        self.publish_heartbeat()
        self.publish_battery()
        self.publish_tilt()


def main():
    rclpy.init()
    try:
        rclpy.spin(VitalSigns())
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
