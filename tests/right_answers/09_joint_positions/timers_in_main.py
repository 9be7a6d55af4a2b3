"""No class at all: functions, closures and timers in main."""

import math

import rclpy
from std_msgs.msg import Float32, Float32MultiArray, String


def main():
    rclpy.init()
    node = rclpy.create_node("humanoid_status_publisher")
    status = node.create_publisher(String, "/robot/status", 10)
    battery = node.create_publisher(Float32, "/robot/battery", 10)
    joints = node.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
    start = node.get_clock().now()

    def robot_seconds():
        return (node.get_clock().now() - start).nanoseconds / 1e9

    def publish_joints():
        t = robot_seconds()
        joints.publish(Float32MultiArray(data=[0.3 * math.sin(t * (1 + joint / 12)) for joint in range(12)]))

    node.create_timer(1.0, lambda: status.publish(String(data="operational")))
    node.create_timer(2.0, lambda: battery.publish(Float32(data=100.0 * math.exp(-robot_seconds() / 3600))))
    node.create_timer(2.0, publish_joints)
    rclpy.spin(node)


if __name__ == "__main__":
    main()
