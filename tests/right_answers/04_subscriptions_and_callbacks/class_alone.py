"""The class and nothing else: whoever runs it makes the node and spins it. A reading that is bad returns early."""

import math

from rclpy.node import Node
from std_msgs.msg import Float32, String


class BatteryMonitor(Node):
    def __init__(self) -> None:
        super().__init__("battery_monitor")
        self.good = self.create_publisher(Float32, "/monitor/battery", 10)
        self.alarm = self.create_publisher(String, "/monitor/alarm", 10)
        self.create_subscription(Float32, "/robot/battery", self.on_battery, 10)

    def on_battery(self, message: Float32) -> None:
        charge = message.data
        if math.isnan(charge) or charge < 0.0 or charge > 100.0:
            self.alarm.publish(String(data=f"ALARM: the sensor says {charge:.1f} %"))
            return
        self.good.publish(Float32(data=charge))
