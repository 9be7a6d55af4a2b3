"""The feedback loop of lesson 15: the head follows the ball."""

import math

import cv2
import numpy as np
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image
from std_msgs.msg import Float32MultiArray

from workbook.pictures.joints import NEUTRAL
from workbook.scenes.painting import Picture

GAIN = 0.25
FOCAL_OF_WIDTH = 0.875  # as in lesson_nodes/head_camera.py
LIMIT_RAD = 0.6
ORANGE = (4, 130, 35), (22, 255, 255)
"""Lower and upper limits of hue, saturation, and value, in OpenCV's ranges."""
ROUND = 0.75
"""A ball fills at least this fraction of its enclosing circle. A brick fills less."""


class HeadFollower(Node):
    """Turns the neck toward the ball in /camera/image (sensor_msgs/Image) by publishing on /robot/joint_positions."""

    def __init__(self) -> None:
        super().__init__("head_follower")
        self.joints = list(NEUTRAL)
        self.publisher = self.create_publisher(Float32MultiArray, "/robot/joint_positions", 10)
        self.create_subscription(Image, "/camera/image", self.on_image, qos_profile_sensor_data)

    def on_image(self, image: Image) -> None:
        """Turn the neck by a part of the angle to the ball, and publish the joint positions (rad)."""
        pixels = np.array(image.data, np.uint8).reshape(image.height, image.width, 3)
        column = ball_column(pixels)
        if column is not None:
            angle = math.atan2(column - (image.width - 1) / 2, FOCAL_OF_WIDTH * image.width)
            self.joints[0] = max(-LIMIT_RAD, min(self.joints[0] - GAIN * angle, LIMIT_RAD))
        self.publisher.publish(Float32MultiArray(data=self.joints))


def ball_column(pixels: Picture) -> float | None:
    """Return the column of the ball's center in an RGB image, or None if no orange object is round."""
    mask = cv2.inRange(cv2.cvtColor(pixels, cv2.COLOR_RGB2HSV), *ORANGE)
    outlines, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    for outline in sorted(outlines, key=cv2.contourArea, reverse=True):
        (column, _), radius = cv2.minEnclosingCircle(outline)
        if radius > 2 and cv2.contourArea(outline) > ROUND * math.pi * radius**2:
            return float(column)
    return None
