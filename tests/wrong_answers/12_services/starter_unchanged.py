# loses: calls_arrive, health_topic
# skips: asks_every_second, results_told, unanswered_told
# says: no client for /robot/self_test
"""Asks the robot once a second to test itself, and tells the control room what came out."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String

HEARTBEAT_PERIOD_S = 0.2  # 5 Hz


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
        self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
        # TODO 1: a publisher for /robot/health
        # TODO 2: a client for the service /robot/self_test (type Trigger, from std_srvs.srv)
        # TODO 3: a timer that asks once a second

    def beat(self) -> None:
        """Say that this node lives."""
        self.heartbeat_publisher.publish(String(data="alive"))

    # TODO 4: the method that your timer calls. It sends the request, and returns at once.
    # TODO 5: who hears of the answer? And who notices that there is none?


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
