# loses: alarm_topic
# skips: alarm_kept, alarm_raised, no_false_alarm, alarm_falls
# says: The publisher is not created
"""A dashboard for the ward robot: its last status, and an alarm when its heart falls silent."""

import time

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

STATE_QOS = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
BEAT_QOS = QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT)
LIMIT_S = 2.0


class Dashboard(Node):
    def __init__(self) -> None:
        super().__init__("dashboard")
        self.last_status = "unknown"
        self.last_beat: float | None = None
        self.alarm = False
        self.line_publisher = self.create_publisher(String, "/dashboard/line", 10)
        self.create_subscription(String, "/robot/status", self.on_status, STATE_QOS)
        self.create_subscription(String, "/robot/heartbeat", self.on_beat, BEAT_QOS)
        self.create_timer(0.5, self.publish_line)
        self.create_timer(0.2, self.look_at_the_clock)

    def on_status(self, message: String) -> None:
        self.last_status = message.data

    def on_beat(self, message: String) -> None:
        self.last_beat = time.monotonic()

    def look_at_the_clock(self) -> None:
        if self.last_beat is None:
            return
        alarm = time.monotonic() - self.last_beat > LIMIT_S
        if alarm != self.alarm:
            self.alarm = alarm
            self.get_logger().warning(f"alarm: {alarm}")

    def publish_line(self) -> None:
        self.line_publisher.publish(String(data=self.last_status))


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(Dashboard())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
