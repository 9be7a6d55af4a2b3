"""A plain class that owns a node, best effort for the fast topic, and one spin_once after another."""

import rclpy
from rclpy.qos import qos_profile_sensor_data
from std_msgs.msg import Float32, String


class Robot:
    def __init__(self, node):
        self.node = node
        self.charge = 100.0
        self.heartbeat = node.create_publisher(String, "/robot/heartbeat", 1)
        self.battery = node.create_publisher(Float32, "/robot/battery", 1)
        self.tilt = node.create_publisher(Float32, "/robot/tilt", qos_profile_sensor_data)
        node.create_timer(1, self.beat)
        node.create_timer(2, self.drain)
        node.create_timer(1 / 5, self.lean)

    def beat(self):
        self.heartbeat.publish(String(data="still here"))

    def drain(self):
        self.charge -= 0.1
        self.battery.publish(Float32(data=self.charge))

    def lean(self):
        self.tilt.publish(Float32(data=0.03))


def main():
    rclpy.init()
    robot = Robot(rclpy.create_node("robot"))
    try:
        while rclpy.ok():
            rclpy.spin_once(robot.node, timeout_sec=0.5)
    except KeyboardInterrupt:
        pass


main()
