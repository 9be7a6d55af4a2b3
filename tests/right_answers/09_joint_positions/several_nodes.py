"""Three nodes with a duty each, in one executor; the battery is nearly empty from the start."""

import random

import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class Battery(Node):
    def __init__(self) -> None:
        super().__init__("battery")
        self.level = 0.7
        self.publisher = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer(2.0, self.tick)

    def tick(self) -> None:
        self.level = max(0.0, self.level - random.uniform(0.1, 0.5))
        self.publisher.publish(Float32(data=self.level))


class Status(Node):
    def __init__(self, battery: Battery) -> None:
        super().__init__("status")
        self.battery = battery
        self.publisher = self.create_publisher(String, "/robot/status", 10)
        self.create_timer(1.0, self.tick)

    def tick(self) -> None:
        self.publisher.publish(String(data="operational" if self.battery.level > 0 else "error"))


class Joints(Node):
    def __init__(self) -> None:
        super().__init__("joints")
        self.publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_timer(2.0, self.tick)

    def tick(self) -> None:
        self.publisher.publish(Float32MultiArray(data=[random.gauss(0.0, 0.3) for _ in range(12)]))


def main() -> None:
    rclpy.init()
    battery = Battery()
    executor = SingleThreadedExecutor()
    for node in (battery, Status(battery), Joints()):
        executor.add_node(node)
    try:
        executor.spin()
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
