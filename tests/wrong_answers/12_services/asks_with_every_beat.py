# loses: asks_every_second
# says: typically 0.2
# says: One timer of 1.0 s
"""Asks the robot once a second to test itself, and tells the control room what came out."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String
from std_srvs.srv import Trigger

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
        self.health_publisher = self.create_publisher(String, "/robot/health", 10)
        self.self_test = self.create_client(Trigger, "/robot/self_test")
        self.open_call: Future | None = None

    def beat(self) -> None:
        """Say that this node lives, and ask."""
        self.ask()
        self.heartbeat_publisher.publish(String(data="alive"))

    def ask(self) -> None:
        """Give up the call of a second ago if it is still open, then send the next one. Waits for nothing."""
        if self.open_call is not None:
            self.waited += 1
            if self.waited < 5:
                return
            self.self_test.remove_pending_request(self.open_call)
            self.report("no answer")
        self.waited = 0
        self.open_call = self.self_test.call_async(Trigger.Request())
        self.open_call.add_done_callback(self.on_answer)

    def on_answer(self, future: Future) -> None:
        """Report the result, unless this call has been given up meanwhile."""
        if future is not self.open_call:
            return
        self.open_call = None
        self.report("ok" if future.result().success else "faulty")

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
