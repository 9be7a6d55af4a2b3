"""The middleware keeps the time: an event tells that the deadline was missed."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.node import Node
from rclpy.qos import QoSDurabilityPolicy, QoSProfile, QoSReliabilityPolicy
from std_msgs.msg import Bool, String


class NightWatch(Node):
    def __init__(self) -> None:
        super().__init__("night_watch")
        latched = QoSProfile(
            depth=1,
            reliability=QoSReliabilityPolicy.RELIABLE,
            durability=QoSDurabilityPolicy.TRANSIENT_LOCAL,
        )
        beats = QoSProfile(
            depth=1, reliability=QoSReliabilityPolicy.BEST_EFFORT, deadline=Duration(seconds=2.0)
        )
        self.status = "unknown"
        self.line = self.create_publisher(String, "/dashboard/line", 1)
        self.alarm = self.create_publisher(Bool, "/dashboard/alarm", latched)
        self.alarm.publish(Bool(data=False))
        self.create_subscription(String, "/robot/status", self.on_status, latched)
        self.create_subscription(
            String,
            "/robot/heartbeat",
            lambda message: self.alarm.publish(Bool(data=False)),
            beats,
            event_callbacks=SubscriptionEventCallbacks(
                deadline=lambda event: self.alarm.publish(Bool(data=True))
            ),
        )
        self.create_timer(0.5, lambda: self.line.publish(String(data=self.status)))

    def on_status(self, message: String) -> None:
        self.status = message.data


def main() -> None:
    rclpy.init()
    rclpy.spin(NightWatch())


if __name__ == "__main__":
    main()
