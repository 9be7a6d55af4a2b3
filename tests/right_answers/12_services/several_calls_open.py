"""Keeps all open calls in a dictionary, each with the moment at which its time is up."""

import rclpy
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from std_msgs.msg import String
from std_srvs.srv import Trigger

PATIENCE = Duration(seconds=1.5)


class Tester(Node):
    """Asks every second, and can wait for more than one answer."""

    def __init__(self) -> None:
        super().__init__("tester", namespace="/robot")
        self.open: dict[object, Time] = {}
        self.cli = self.create_client(Trigger, "self_test")
        self.pub = self.create_publisher(String, "health", 10)
        self.hb = self.create_publisher(String, "heartbeat", 10)
        self.create_timer(1.0, self.ask)
        self.create_timer(0.1, self.sweep)
        self.create_timer(0.2, self.beat)

    def beat(self) -> None:
        self.hb.publish(String(data="alive"))

    def ask(self) -> None:
        future = self.cli.call_async(Trigger.Request())
        self.open[future] = self.get_clock().now() + PATIENCE
        future.add_done_callback(self.done)

    def done(self, future) -> None:
        if self.open.pop(future, None) is not None:
            self.say("ok" if future.result().success else "faulty")

    def sweep(self) -> None:
        now = self.get_clock().now()
        for future in [one for one, until in self.open.items() if until < now]:
            del self.open[future]
            self.cli.remove_pending_request(future)
            self.say("no answer")

    def say(self, word: str) -> None:
        self.pub.publish(String(data=word))


def main(args=None):
    rclpy.init(args=args)
    node = Tester()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    node.destroy_node()
    rclpy.try_shutdown()


main()
