"""The deadline that is offered, and four of them in a row for an alarm."""

import rclpy
from rclpy.duration import Duration
from rclpy.event_handler import SubscriptionEventCallbacks
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Bool, String

MISSES_FOR_AN_ALARM = 4  # of 0.5 s each


class Dashboard(Node):
    def __init__(self) -> None:
        super().__init__("dashboard")
        kept = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.status = "unknown"
        self.missed = 0
        self.line = self.create_publisher(String, "/dashboard/line", 10)
        self.alarm = self.create_publisher(Bool, "/dashboard/alarm", kept)
        self.create_subscription(String, "/robot/status", self.on_status, kept)
        self.create_subscription(
            String,
            "/robot/heartbeat",
            self.on_beat,
            QoSProfile(depth=10, reliability=ReliabilityPolicy.BEST_EFFORT, deadline=Duration(seconds=0.5)),
            event_callbacks=SubscriptionEventCallbacks(deadline=self.on_missed),
        )
        self.create_timer(0.5, self.publish_line)

    def on_status(self, message):
        self.status = message.data

    def on_beat(self, message):
        self.missed = 0

    def on_missed(self, event):
        self.missed += event.total_count_change

    def publish_line(self):
        text = "all well" if self.missed < MISSES_FOR_AN_ALARM else "HEART SILENT"
        self.line.publish(String(data=f"[{text}] the robot says: {self.status}"))
        self.alarm.publish(Bool(data=self.missed >= MISSES_FOR_AN_ALARM))


def main():
    rclpy.init()
    node = Dashboard()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
