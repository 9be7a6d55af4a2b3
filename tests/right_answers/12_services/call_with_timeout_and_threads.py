"""call() with a time-out: three callback groups and as many threads."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class SelfTester(Node):
    def __init__(self) -> None:
        super().__init__("self_tester")
        waiting, answers = MutuallyExclusiveCallbackGroup(), MutuallyExclusiveCallbackGroup()
        self.health_pub = self.create_publisher(String, "/robot/health", 10)
        self.heartbeat_pub = self.create_publisher(String, "/robot/heartbeat", 10)
        self.client = self.create_client(Trigger, "/robot/self_test", callback_group=answers)
        self.ask_timer = self.create_timer(1.0, self.ask, callback_group=waiting)
        self.beat_timer = self.create_timer(0.2, self.beat)

    def beat(self) -> None:
        self.heartbeat_pub.publish(String(data="tick"))

    def ask(self) -> None:
        response = self.client.call(Trigger.Request(), timeout_sec=0.95)
        if response is None:
            word = "no answer"
        else:
            word = "ok" if response.success else "faulty"
        self.health_pub.publish(String(data=word))


def main() -> None:
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=4)
    executor.add_node(SelfTester())
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
