"""Awaits in the timer that asks; a one-shot timer completes the future of a call that got no answer."""

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String
from std_srvs.srv import Trigger


class HealthMonitor(Node):
    def __init__(self):
        super().__init__("health_monitor")
        self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
        self.health_publisher = self.create_publisher(String, "/robot/health", 10)
        self.client = self.create_client(Trigger, "/robot/self_test")
        self.create_timer(0.2, self.beat)
        self.create_timer(1.0, self.ask, callback_group=ReentrantCallbackGroup())

    def beat(self):
        self.heartbeat_publisher.publish(String(data="alive"))

    async def ask(self):
        future = self.client.call_async(Trigger.Request())

        def give_up():
            timer.cancel()
            if not future.done():
                self.client.remove_pending_request(future)
                future.set_result(None)

        timer = self.create_timer(1.3, give_up)
        response = await future
        timer.cancel()
        self.destroy_timer(timer)
        if response is None:
            text = "no answer"
        elif response.success:
            text = "ok"
        else:
            text = "faulty"
        self.health_publisher.publish(String(data=text))


def main(args=None):
    rclpy.init(args=args)
    try:
        rclpy.spin(HealthMonitor())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
