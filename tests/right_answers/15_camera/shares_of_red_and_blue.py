"""Which share of the light is red and which is blue; an ellipse around the outline."""

import math

import cv2
import numpy as np
import rclpy
from geometry_msgs.msg import Vector3Stamped
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image


def find(rgb):
    smooth = cv2.blur(np.ascontiguousarray(rgb), (3, 3)).astype(np.float32) + 1.0
    whole = smooth.sum(axis=2)
    mask = ((smooth[..., 0] / whole > 0.5) & (smooth[..., 2] / whole < 0.18)).astype(np.uint8)
    outlines, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    for outline in outlines:
        if len(outline) >= 12:
            center, (short, long), _ = cv2.fitEllipse(outline)
            if short > 0.72 * long:
                return center
    return None


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
