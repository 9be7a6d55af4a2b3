"""A loop of spin_once that ends when the context does; a sensor that counts whole percents."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import Float32, String


class Humanoid(Node):
    def __init__(self) -> None:
        super().__init__("humanoid")
        self.percent: int = 100
        self.status = self.create_publisher(String, "/robot/status", 10)
        self.battery = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer(1.0, lambda: self.status.publish(String(data="operational")))
        self.create_timer(2.0, self.report)

    def report(self) -> None:
        self.percent = max(0, self.percent - 1)
        self.battery.publish(Float32(data=float(self.percent)))


def main() -> None:
    rclpy.init()
    robot = Humanoid()
    try:
        while rclpy.ok():
            rclpy.spin_once(robot, timeout_sec=0.5)
    except (KeyboardInterrupt, ExternalShutdownException):
        print("stopped")
    robot.destroy_node()
    rclpy.try_shutdown()


if __name__ == "__main__":
    main()
