"""All joints at once with NumPy, handed over with tolist."""

import numpy as np
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String

RNG = np.random.default_rng(7)
PHASES = np.linspace(0.0, np.pi, 12)


class HumanoidStatusPublisher(Node):
    def __init__(self) -> None:
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0
        self.status_pub = self.create_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_publisher(Float32, "/robot/battery", 10)
        self.joint_pub = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery)
        self.create_timer(1.0 / 0.5, self.publish_joint_positions)

    def publish_status(self) -> None:
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self) -> None:
        self.battery_level = float(np.clip(self.battery_level - RNG.uniform(0.1, 0.5), 0.0, 100.0))
        self.battery_pub.publish(Float32(data=self.battery_level))

    def publish_joint_positions(self) -> None:
        seconds = self.get_clock().now().nanoseconds / 1e9
        angles = 0.6 * np.sin(0.5 * seconds + PHASES) + RNG.normal(0.0, 0.01, size=12)
        self.joint_pub.publish(Float32MultiArray(data=np.clip(angles, -np.pi, np.pi).tolist()))


def main(args=None) -> None:
    rclpy.init(args=args)
    node = HumanoidStatusPublisher()
    try:
        rclpy.spin(node)
    except KeyboardInterrupt:
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
