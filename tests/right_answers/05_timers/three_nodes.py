"""Three nodes, one rhythm each, in one executor."""

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float32, String


class Reporter(Node):
    def __init__(self, what, message, period_s):
        super().__init__(f"{what}_reporter", namespace="robot")
        self.message = message
        self.publisher = self.create_publisher(type(message), what, 10)
        self.timer = self.create_timer(period_s, self.report)

    def report(self):
        self.publisher.publish(self.message)


def main():
    rclpy.init()
    executor = SingleThreadedExecutor()
    for what, message, period_s in (
        ("heartbeat", String(data="alive"), 1.0),
        ("battery", Float32(data=64.0), 2.0),
        ("tilt", Float32(data=0.1), 0.2),
    ):
        executor.add_node(Reporter(what, message, period_s))
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        executor.shutdown()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
