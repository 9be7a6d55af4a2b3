# loses: no_number_refused, look_alikes_refused, not_finite_refused
# cause: refusal.silent
# says: published: nothing
"""Writes a warning into the log, and goes on as if nothing had been."""

from rclpy.node import Node
from std_msgs.msg import Float32


class BatteryPublisher(Node):
    def __init__(self) -> None:
        super().__init__("battery_publisher")
        self.battery_publisher = self.create_publisher(Float32, "/robot/battery", 10)

    def publish_level(self, level) -> None:
        try:
            charge = float(level)
        except (TypeError, ValueError):
            self.get_logger().warning(f"ignored {level!r}")
            return
        self.battery_publisher.publish(Float32(data=charge))
