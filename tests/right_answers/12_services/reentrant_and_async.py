"""One reentrant group for everything that has to do with the call; the future is cancelled by the next question."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class HealthMonitor(Node):
    def __init__(self):
        super().__init__("health_monitor")
        group = ReentrantCallbackGroup()
        self.publisher = self.create_publisher(String, "/robot/health", 10)
        self.beats = self.create_publisher(String, "/robot/heartbeat", 10)
        self.client = self.create_client(Trigger, "/robot/self_test", callback_group=group)
        self.create_timer(1.0, self.ask, callback_group=group)
        self.create_timer(0.2, self.beat)
        self.last = None

    def beat(self):
        self.beats.publish(String(data="alive"))

    async def ask(self):
        if self.last is not None and not self.last.done():
            self.last.cancel()
        future = self.last = self.client.call_async(Trigger.Request())
        response = await future
        words = {None: "no answer", True: "ok", False: "faulty"}
        self.publisher.publish(String(data=words[response and response.success]))


def main():
    rclpy.init()
    executor = MultiThreadedExecutor(2)
    executor.add_node(HealthMonitor())
    try:
        executor.spin()
    except KeyboardInterrupt:
        pass
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
