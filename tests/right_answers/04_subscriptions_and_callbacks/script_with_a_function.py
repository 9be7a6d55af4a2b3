"""A script: a node made on the spot, and a function as its callback."""

import rclpy
from std_msgs.msg import Float32, String

rclpy.init()
node = rclpy.create_node("battery", namespace="/monitor")
battery = node.create_publisher(Float32, "battery", 10)
alarm = node.create_publisher(String, "alarm", 10)


def on_battery(msg):
    if 0 <= msg.data <= 100:
        battery.publish(msg)
    else:
        alarm.publish(String(data="bad: " + str(msg.data)))


node.create_subscription(Float32, "/robot/battery", on_battery, 5)
try:
    while rclpy.ok():
        rclpy.spin_once(node, timeout_sec=0.1)
except KeyboardInterrupt:
    pass
