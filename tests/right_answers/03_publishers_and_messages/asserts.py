"""Assertions, and the field check of this one message as a second net."""

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self):
        super().__init__("battery_publisher")
        self.battery = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level):
        assert type(level) is not bool, "a bool is not a charge"
        assert hasattr(level, "__float__"), "a charge is a number"
        percent = float(level)
        assert 0.0 <= percent <= 100.0, "a charge lies between 0 and 100 %"
        self.battery.publish(Float32(data=percent, check_fields=True))
