"""NumPy and SciPy only: ratios of colors, and labels of connected pixels."""

import math

import numpy as np
import rclpy
from geometry_msgs.msg import Vector3Stamped
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from scipy import ndimage
from sensor_msgs.msg import Image


def find(rgb):
    red, green, blue = (rgb[..., channel].astype(float) + 1.0 for channel in range(3))
    labels, number = ndimage.label(ndimage.binary_opening((red > 1.4 * green) & (green > 1.5 * blue) & (red > 30)))
    best = None
    for label in range(1, number + 1):
        ys, xs = np.nonzero(labels == label)
        wide, high = np.ptp(xs) + 1, np.ptp(ys) + 1
        if len(xs) > 25 and 0.65 < wide / high < 1.5 and (best is None or len(xs) > best[0]):
            best = len(xs), xs.mean(), ys.mean()
    return best and best[1:]


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
