"""One node passes on, another one warns. Both ask the same function what a good reading is."""

import math

import rclpy
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float32, String


def is_good(charge: float) -> bool:
    return math.isfinite(charge) and 0.0 <= charge <= 100.0


class Filter(Node):
    def __init__(self) -> None:
        super().__init__("battery_filter")
        self.out = self.create_publisher(Float32, "/monitor/battery", 50)
        self.create_subscription(Float32, "/robot/battery", self.on_battery, 50)

    def on_battery(self, message: Float32) -> None:
        if is_good(message.data):
            self.out.publish(message)


class Warner(Node):
    def __init__(self) -> None:
        super().__init__("battery_warner")
        self.out = self.create_publisher(String, "/monitor/alarm", 50)
        self.create_subscription(Float32, "/robot/battery", self.on_battery, 50)

    def on_battery(self, message: Float32) -> None:
        if not is_good(message.data):
            self.get_logger().error(f"bad reading {message.data}")
            self.out.publish(String(data=f"{message.data} is no charge"))


def main() -> None:
    rclpy.init()
    executor = MultiThreadedExecutor(num_threads=2)
    executor.add_node(Filter())
    executor.add_node(Warner())
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
