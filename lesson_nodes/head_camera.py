"""Simulate the camera in a humanoid's head. Its images show the robot's hands, a ball, and a desk.

Run it with ``python -m lesson_nodes.head_camera`` and end it with Ctrl-C.
"""

import math
import time
from array import array
from typing import Any

import cv2
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import CompressedImage, Image
from std_msgs.msg import Float32MultiArray

from workbook.scenes.desk import DeskCamera
from workbook.scenes.encodings import encoded
from workbook.scenes.painting import Picture
from workbook.scenes.pinhole import Pinhole
from workbook.scenes.scene import Box, Scene, on_desk

PERIOD_S = 1 / 30
LONGEST_WAIT_S = 0.5
WIDTH = 640
SEED = 15
TOPIC = "/camera/image"
FOCAL_OF_WIDTH = 0.875
AT_REST = (0.0, 0.0, 0.8, 0.8, 0.8, 0.8, 0.06, 0.06, 0.0, 0.06, 0.06, 0.0)
BRICKS = (Box((1.25, 0.5), turn=0.4), Box((1.3, -0.55), turn=-0.5))


def pinhole(width: int) -> Pinhole:
    """Return the camera model for images of this width, with an aspect ratio of 4:3."""
    return Pinhole(width, 3 * width // 4, FOCAL_OF_WIDTH * width)


def ball_at(seconds: float) -> tuple[float, float, float]:
    """Return the ball's position at a time (s). It rolls back and forth, 0.74 m to 0.90 m in front of the robot."""
    return on_desk(0.82 + 0.08 * math.sin(0.5 * seconds), 0.42 * math.sin(0.9 * seconds))


def light_at(seconds: float) -> float:
    """Return the brightness at a time (s), 1 being a bright day. It changes as clouds pass by."""
    return 0.75 + 0.3 * math.sin(0.6 * seconds)


def scene_at(seconds: float, joints: tuple[float, ...] = AT_REST) -> Scene:
    """Return the scene at a time (s), with the robot's joints at these angles (rad)."""
    return Scene(ball_at(seconds), None, BRICKS, joints, joints[0], light_at(seconds))


def frame(number: int, width: int = WIDTH) -> Picture:
    """Render the frame with this number as an RGB array, without a node. The head and the arms are at rest."""
    return DeskCamera(pinhole(width), SEED).picture(scene_at(number * PERIOD_S), number)


class HeadCamera(Node):
    """Publishes the head camera's images. Passes `settings` to Node. The same seed produces the same images.

    Topics:
        /camera/image (sensor_msgs/Image): images of `width` by 3/4 `width` pixels, best effort.

        /camera/image/compressed (sensor_msgs/CompressedImage): the same images as JPEG, if `jpeg_quality` is above 0.

    Subscriptions:
        /robot/joint_positions (std_msgs/Float32MultiArray): 12 angles (rad). The neck turns the camera (positive: to
            the left). The shoulders and elbows move the hands.

    Parameters:
        period_s (float): Time between two images, in seconds.
        width (int): Width of the images, in pixels.
        encoding (str): rgb8, bgr8, or mono8.
        padding (int): Unused bytes at the end of each row.
        seed (int): Seed of the sensor's noise.
        jpeg_quality (int): Quality of the compressed images, from 1 to 100. With 0, none are published.
        waits (bool): Whether each image waits for joint positions that arrive after the previous image, for at most
            0.5 s. Otherwise, images would be outdated at random times on a busy computer.
        frozen (int): Number of the frame to publish again and again. With a negative number, the ball rolls.

    Raises:
        ValueError: The period is not a positive number, or the width or the encoding is not supported.
    """

    def __init__(self, **settings: Any) -> None:
        super().__init__("head_camera", **settings)
        self.period_s: float = self.declare_parameter("period_s", PERIOD_S).value
        if not 0.0 < self.period_s < math.inf:
            raise ValueError(f"The period is the time between two pictures in seconds, not {self.period_s}.")
        width: int = self.declare_parameter("width", WIDTH).value
        if not 16 <= width <= 1920 or width % 4:
            raise ValueError(f"The width is a multiple of 4 from 16 to 1920, not {width}.")
        self.encoding: str = self.declare_parameter("encoding", "rgb8").value
        if self.encoding not in ("rgb8", "bgr8", "mono8"):
            raise ValueError(f"The encoding is rgb8, bgr8 or mono8, not {self.encoding!r}.")
        self.padding: int = self.declare_parameter("padding", 0).value
        self.camera = DeskCamera(pinhole(width), self.declare_parameter("seed", SEED).value)
        self.jpeg_quality: int = self.declare_parameter("jpeg_quality", 0).value
        self.frozen: int = self.declare_parameter("frozen", -1).value
        self.waits: bool = self.declare_parameter("waits", False).value
        self.waiting_since: float | None = None
        self.joints: tuple[float, ...] = AT_REST
        self.count = 0
        self.image_publisher = self.create_publisher(Image, TOPIC, qos_profile_sensor_data)
        self.jpeg_publisher = self.create_publisher(
            CompressedImage, f"{TOPIC}/compressed", qos_profile_sensor_data
        )
        self.create_subscription(Float32MultiArray, "/robot/joint_positions", self.on_joints, 10)
        self.timer = self.create_timer(self.period_s, self.take_picture)

    def on_joints(self, message: Float32MultiArray) -> None:
        """Store the joint angles for the next image, if they are 12 finite numbers."""
        if len(message.data) == len(AT_REST) and all(map(math.isfinite, message.data)):
            self.joints = tuple(message.data)
            self.waiting_since = None

    def take_picture(self) -> None:
        """Publish an image, unless the node is still waiting for joint positions."""
        now = time.monotonic()
        if self.waiting_since is None or now - self.waiting_since >= LONGEST_WAIT_S:
            self.waiting_since = now if self.waits else None
            self.publish_picture()

    def publish_picture(self) -> None:
        """Render the current image, and publish it with the current time as its stamp."""
        image = Image()
        image.header.stamp = self.get_clock().now().to_msg()
        image.header.frame_id = "head_camera_optical_frame"
        number = self.count if self.frozen < 0 else self.frozen
        picture = self.camera.picture(scene_at(number * self.period_s, self.joints), number)
        data, image.step = encoded(picture, self.encoding, self.padding)
        image.data = array("B", data)  # the field keeps this array, but copies other types byte by byte
        image.height, image.width = picture.shape[:2]
        image.encoding = self.encoding
        self.image_publisher.publish(image)
        if self.jpeg_quality > 0:
            jpeg = CompressedImage(header=image.header, format="rgb8; jpeg compressed bgr8")
            bgr = cv2.cvtColor(picture, cv2.COLOR_RGB2BGR)
            _, coded = cv2.imencode(".jpg", bgr, [cv2.IMWRITE_JPEG_QUALITY, self.jpeg_quality])
            jpeg.data = array("B", coded.tobytes())
            self.jpeg_publisher.publish(jpeg)
        self.count += 1


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(HeadCamera())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
