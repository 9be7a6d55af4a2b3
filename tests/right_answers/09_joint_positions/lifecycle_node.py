"""A lifecycle node that configures and activates itself."""

import random

import rclpy
from rclpy.lifecycle import LifecycleNode, LifecycleState, TransitionCallbackReturn
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(LifecycleNode):
    def __init__(self):
        super().__init__("humanoid_status_publisher")
        self.battery_level = 100.0

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.status_pub = self.create_lifecycle_publisher(String, "/robot/status", 10)
        self.battery_pub = self.create_lifecycle_publisher(Float32, "/robot/battery", 10)
        self.joint_pub = self.create_lifecycle_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        return TransitionCallbackReturn.SUCCESS

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        self.create_timer(1.0, self.publish_status)
        self.create_timer(2.0, self.publish_battery)
        self.create_timer(2.0, self.publish_joints)
        return super().on_activate(state)

    def publish_status(self):
        self.status_pub.publish(String(data="operational"))

    def publish_battery(self):
        self.battery_level = max(0.0, self.battery_level - random.uniform(0.1, 0.5))
        self.battery_pub.publish(Float32(data=self.battery_level))

    def publish_joints(self):
        self.joint_pub.publish(Float32MultiArray(data=[random.uniform(-1.0, 1.0) for _ in range(12)]))


def main():
    rclpy.init()
    node = HumanoidStatusPublisher()
    node.trigger_configure()
    node.trigger_activate()
    rclpy.spin(node)


if __name__ == "__main__":
    main()
