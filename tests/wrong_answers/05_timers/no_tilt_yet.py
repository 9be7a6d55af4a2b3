# loses: tilt_topic
# skips: tilt_count
# says: The publisher is not created
"""The tilt is still to be done; the battery is no misspelled tilt."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String


class VitalSigns(Node):
    def __init__(self):
        super().__init__("vital_signs")
        self.level = 100.0
        self.heartbeat_pub = self.create_publisher(String, "/robot/heartbeat", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer(1.0, self.publish_heartbeat)
        self.create_timer(2.0, self.publish_battery)

    def publish_heartbeat(self):
        self.heartbeat_pub.publish(String(data="alive"))

    def publish_battery(self):
        self.level = max(0.0, self.level - 0.2)
        self.battery_pub.publish(Float32(data=self.level))


def main():
    rclpy.init()
    try:
        rclpy.spin(VitalSigns())
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
