# loses: calls_arrive
# skips: asks_every_second, results_told, unanswered_told
# says: one single call
# says: client and callback share a callback group
"""Asks the robot once a second to test itself, and tells the control room what came out."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger

HEARTBEAT_PERIOD_S = 0.2  # 5 Hz
ASK_PERIOD_S = 1.0


class HealthMonitor(Node):
    """Asks for a self-test again and again, and reports each result.

    Topics:
        /robot/heartbeat (std_msgs/String), 5 Hz: "alive".
        /robot/health (std_msgs/String): "ok", "faulty" or "no answer", once for each call.

    Calls:
        /robot/self_test (std_srvs/Trigger), once a second.
    """

    def __init__(self) -> None:
        super().__init__("health_monitor")
        self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
        self.create_timer(HEARTBEAT_PERIOD_S, self.beat, callback_group=MutuallyExclusiveCallbackGroup())
        self.health_publisher = self.create_publisher(String, "/robot/health", 10)
        self.self_test = self.create_client(Trigger, "/robot/self_test")
        self.create_timer(ASK_PERIOD_S, self.ask)

    def beat(self) -> None:
        """Say that this node lives."""
        self.heartbeat_publisher.publish(String(data="alive"))

    async def ask(self) -> None:
        """Ask, and report the result."""
        response = await self.self_test.call_async(Trigger.Request())
        self.report("ok" if response.success else "faulty")

    def report(self, health: str) -> None:
        """Tell the control room."""
        self.health_publisher.publish(String(data=health))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(HealthMonitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
