"""Three asyncio tasks publish and sleep; nothing is spun, because publishing needs no spin."""

import asyncio
import math
import time

import rclpy
from std_msgs.msg import Float32, Float32MultiArray, String


async def every(period, publish):
    due = time.monotonic()
    while True:
        due += period
        await asyncio.sleep(due - time.monotonic())
        publish()


async def main():
    rclpy.init()
    node = rclpy.create_node("humanoid_status_publisher")
    status = node.create_publisher(String, "/robot/status", 10)
    battery = node.create_publisher(Float32, "/robot/battery", 10)
    joints = node.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
    level = 100.0

    def publish_battery():
        nonlocal level
        level = max(0.0, level - 0.2)
        battery.publish(Float32(data=level))

    def publish_joints():
        now = time.monotonic()
        joints.publish(Float32MultiArray(data=[math.sin(now + joint) for joint in range(12)]))

    await asyncio.gather(
        every(1.0, lambda: status.publish(String(data="operational"))),
        every(2.0, publish_battery),
        every(2.0, publish_joints),
    )


asyncio.run(main())
