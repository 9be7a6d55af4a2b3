"""Line and alarm on every tick of one timer, by the clock of the node."""

import rclpy
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from std_msgs.msg import Bool, String

LIMIT = Duration(seconds=2)


class Dashboard(Node):
    """The line and the alarm of one robot."""

    def __init__(self) -> None:
        super().__init__("dashboard", namespace="dashboard")
        state = QoSProfile(
            history=HistoryPolicy.KEEP_LAST, depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL
        )
        stream = QoSProfile(
            history=HistoryPolicy.KEEP_LAST, depth=10, reliability=ReliabilityPolicy.BEST_EFFORT
        )
        self.status = "unknown"
        self.beat_at = self.get_clock().now()
        self.line = self.create_publisher(String, "line", 10)
        self.alarm = self.create_publisher(Bool, "alarm", state)
        self.create_subscription(String, "/robot/status", self.on_status, state)
        self.create_subscription(String, "/robot/heartbeat", self.on_beat, stream)
        self.create_timer(0.5, self.tick)

    def on_status(self, message: String) -> None:
        self.status = message.data

    def on_beat(self, _: String) -> None:
        self.beat_at = self.get_clock().now()

    def tick(self) -> None:
        self.line.publish(String(data=self.status))
        self.alarm.publish(Bool(data=self.get_clock().now() - self.beat_at > LIMIT))


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
