"""Nothing but the class: no main, no init, no spin."""

from rclpy.node import Node
from std_msgs.msg import Float32, String


class VitalSigns(Node):
    def __init__(self) -> None:
        super().__init__("vital_signs")
        heartbeat = self.create_publisher(String, "/robot/heartbeat", 10)
        battery = self.create_publisher(Float32, "/robot/battery", 10)
        tilt = self.create_publisher(Float32, "/robot/tilt", 10)
        self.create_timer(1.0, lambda: heartbeat.publish(String(data="alive")))
        self.create_timer(2.0, lambda: battery.publish(Float32(data=55.5)))
        self.create_timer(0.2, lambda: tilt.publish(Float32(data=-0.02)))
