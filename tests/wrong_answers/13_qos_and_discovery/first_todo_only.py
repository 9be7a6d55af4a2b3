# loses: hears_heartbeat, alarm_topic
# skips: alarm_kept, alarm_raised, no_false_alarm, alarm_falls
# says: No create_subscription() call was reached
"""A dashboard that may come late: it knows the last status at once, and notices when the robot falls silent."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

LINE_PERIOD_S = 0.5


class Dashboard(Node):
    """Shows the last status of the robot, and raises an alarm when its heart is silent."""

    def __init__(self) -> None:
        super().__init__("dashboard")
        self.last_status = "unknown"
        self.line_publisher = self.create_publisher(String, "/dashboard/line", 10)
        state_qos = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(String, "/robot/status", self.on_status, state_qos)
        # TODO 2: subscribe to /robot/heartbeat, and note when the last beat came
        # TODO 3: publish /dashboard/alarm (Bool), kept for those who come later
        # TODO 4: notice the silence: who calls you when nothing comes?
        self.create_timer(LINE_PERIOD_S, self.publish_line)

    def on_status(self, message: String) -> None:
        """Remember the status."""
        self.last_status = message.data

    def publish_line(self) -> None:
        """Show what is known."""
        self.line_publisher.publish(String(data=self.last_status))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C."""
    rclpy.init(args=args)
    try:
        rclpy.spin(Dashboard())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
