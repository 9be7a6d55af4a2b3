# loses: heartbeat_count, battery_count, tilt_count
# cause: rate.too-slow
# says: create_timer(1.0
"""One loop with sleeps for everything: the rhythms add up instead of running side by side."""

import time

import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32, String


def main():
    rclpy.init()
    node = Node("vital_signs")
    heartbeat = node.create_publisher(String, "/robot/heartbeat", 10)
    battery = node.create_publisher(Float32, "/robot/battery", 10)
    tilt = node.create_publisher(Float32, "/robot/tilt", 10)
    while rclpy.ok():
        heartbeat.publish(String(data="alive"))
        time.sleep(1.0)
        battery.publish(Float32(data=70.0))
        time.sleep(2.0)
        tilt.publish(Float32(data=0.0))
        time.sleep(0.2)


if __name__ == "__main__":
    main()
