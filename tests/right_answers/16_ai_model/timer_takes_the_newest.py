"""A timer in a group of its own looks at the newest picture 20 times a second, when it is free."""

import math

import numpy as np
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from sensor_msgs.msg import Image, Imu
from std_msgs.msg import String
from visualization_msgs.msg import Marker, MarkerArray

from workbook.models.slow import SlowDetector

rclpy.init()
node = Node("watcher")
model = SlowDetector()
detections = node.create_publisher(MarkerArray, "/robot/detections", 5)
status = node.create_publisher(String, "/robot/status", 5)
newest: list[Image] = []
fall = {"since": None, "happened": False}


def keep(image):
    newest[:] = [image]


def look():
    if not newest:
        return
    image = newest.pop()
    array = np.asarray(image.data, dtype=np.uint8).reshape(image.height, image.step)[:, : 3 * image.width]
    try:
        found = model(np.flip(array.reshape(image.height, image.width, 3), axis=2))
    except RuntimeError as error:
        node.get_logger().error(f"cannot see: {error}", throttle_duration_sec=1.0)
        return
    message = MarkerArray()
    for one in found:
        message.markers.append(Marker(header=image.header, ns=one.label))
        message.markers[-1].pose.position.x = float(one.u)
        message.markers[-1].pose.position.y = float(one.v)
    detections.publish(message)


def feel(imu):
    up = imu.linear_acceleration
    stamp = imu.header.stamp.sec + imu.header.stamp.nanosec * 1e-9
    if math.atan2(math.hypot(up.x, up.y), up.z) <= math.pi / 3:
        fall["since"] = None
        return
    if fall["since"] is None:
        fall["since"] = stamp
    if stamp - fall["since"] > 0.17 and not fall["happened"]:
        fall["happened"] = True
        status.publish(String(data="error"))  # at once, and then with every beat


def beat():
    status.publish(String(data="error" if fall["happened"] else "operational"))


node.create_subscription(Image, "/camera/image", keep, 1)
node.create_subscription(Imu, "/robot/imu", feel, 10)
node.create_timer(0.1, beat)
node.create_timer(0.05, look, callback_group=MutuallyExclusiveCallbackGroup())
executor = MultiThreadedExecutor(3)
executor.add_node(node)
try:
    executor.spin()
except KeyboardInterrupt:
    pass
