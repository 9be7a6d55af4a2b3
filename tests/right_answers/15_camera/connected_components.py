"""Connected components with their boxes."""

import math

import cv2
import numpy as np
import rclpy
from geometry_msgs.msg import Vector3Stamped
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image


def find(rgb):
    hsv = cv2.cvtColor(np.ascontiguousarray(rgb), cv2.COLOR_RGB2HSV)
    mask = cv2.medianBlur(cv2.inRange(hsv, (4, 120, 30), (24, 255, 255)), 3)
    number, _, stats, centers = cv2.connectedComponentsWithStats(mask)
    good = []
    for label in range(1, number):
        _, _, wide, high, area = stats[label]
        if area > 25 and 2 * max(wide, high) < 3 * min(wide, high):
            good.append((area, *centers[label]))
    return max(good)[1:] if good else None


class Tracker(Node):
    def __init__(self):
        super().__init__("tracker")
        self.publisher = self.create_publisher(Vector3Stamped, "/robot/ball_direction", 10)
        self.create_subscription(Image, "/camera/image", self.look, qos_profile_sensor_data)

    def look(self, image):
        if image.encoding not in ("rgb8", "bgr8"):
            self.get_logger().warning("unknown encoding: " + image.encoding)
            return
        rows = np.asarray(image.data, dtype=np.uint8).reshape(image.height, image.step)
        rgb = rows[:, : 3 * image.width].reshape(image.height, image.width, 3)
        if image.encoding == "bgr8":
            rgb = rgb[..., ::-1]
        answer = Vector3Stamped()
        answer.header = image.header
        ball = find(rgb)
        if ball is not None:
            x, y = (ball[0] - 79.5) / 140.0, (ball[1] - 59.5) / 140.0
            length = math.hypot(x, y, 1.0)
            answer.vector.x, answer.vector.y, answer.vector.z = x / length, y / length, 1.0 / length
        self.publisher.publish(answer)


rclpy.init()
try:
    rclpy.spin(Tracker())
except KeyboardInterrupt:
    pass
