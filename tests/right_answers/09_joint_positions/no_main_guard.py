"""The program calls main() at its end, without asking whether it is the main program."""

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, Float32MultiArray, String


class HumanoidStatusPublisher(Node):
    def __init__(self):
        super().__init__('humanoid_status_publisher')
        self.status_pub = self.create_publisher(String, '/robot/status', 10)
        self.battery_pub = self.create_publisher(Float32, '/robot/battery', 10)
        self.joint_pub = self.create_publisher(Float32MultiArray, '/robot/joint_positions', 10)
        self.status_timer = self.create_timer(1.0, self.publish_status)
        self.battery_timer = self.create_timer(2.0, self.publish_battery)
        self.joint_timer = self.create_timer(2.0, self.publish_joints)
        self.battery_level = 100.0
        self.poses = [[0.1] * 12, [0.2] * 12, [0.3] * 12, [0.2] * 12]
        self.pose = 0

    def publish_status(self):
        msg = String()
        msg.data = 'operational'
        self.status_pub.publish(msg)

    def publish_battery(self):
        self.battery_level -= 0.3
        msg = Float32()
        msg.data = max(0.0, self.battery_level)
        self.battery_pub.publish(msg)

    def publish_joints(self):
        msg = Float32MultiArray()
        msg.data = self.poses[self.pose % len(self.poses)]
        self.pose += 1
        self.joint_pub.publish(msg)


def main(args=None):
    rclpy.init(args=args)
    node = HumanoidStatusPublisher()
    rclpy.spin(node)
    node.destroy_node()
    rclpy.shutdown()


main()
