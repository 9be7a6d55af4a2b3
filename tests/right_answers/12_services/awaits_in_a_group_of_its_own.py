"""Asks with await: client, questions, watchdog and heartbeat each have a callback group of their own."""

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class HealthMonitor(Node):
    def __init__(self):
        super().__init__("health_monitor")
        self.health = self.create_publisher(String, "/robot/health", 10)
        self.heart = self.create_publisher(String, "/robot/heartbeat", 10)
        self.client = self.create_client(
            Trigger, "/robot/self_test", callback_group=MutuallyExclusiveCallbackGroup()
        )
        self.future = None
        self.create_timer(1.0, self.ask, callback_group=MutuallyExclusiveCallbackGroup())
        self.watchdog = self.create_timer(
            0.95, self.give_up, callback_group=MutuallyExclusiveCallbackGroup(), autostart=False
        )
        self.create_timer(0.2, lambda: self.heart.publish(String(data="beat")))

    async def ask(self):
        self.future = self.client.call_async(Trigger.Request())
        self.watchdog.reset()
        response = await self.future
        self.watchdog.cancel()
        if response is None:
            self.health.publish(String(data="no answer"))
        elif response.success:
            self.health.publish(String(data="ok"))
        else:
            self.health.publish(String(data="faulty"))

    def give_up(self):
        self.watchdog.cancel()
        self.future.cancel()


def main():
    rclpy.init()
    rclpy.spin(HealthMonitor())


if __name__ == "__main__":
    main()
