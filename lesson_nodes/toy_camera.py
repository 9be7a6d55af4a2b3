"""Simulate a camera above a desk with toys: a ball rolls past a cup, a plate, and a brick, all of them orange.

Run it with ``python -m lesson_nodes.toy_camera`` and end it with Ctrl-C.
"""

import math
from array import array
from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image

from workbook.scenes.desk import DeskCamera
from workbook.scenes.pinhole import Pinhole
from workbook.scenes.scene import Box, Cup, Plate, Scene, on_desk

PERIOD_S = 1 / 30
WIDTH = 160
SEED = 16
TOPIC = "/camera/image"
FOCAL_OF_WIDTH = 0.875
BRICKS = (Box((1.05, 0.42), turn=0.5),)
CUPS = (Cup((1.08, -0.12)),)
PLATES = (Plate((1.12, -0.5)),)


def pinhole(width: int) -> Pinhole:
    """Return the camera model for images of this width, with an aspect ratio of 4:3."""
    return Pinhole(width, 3 * width // 4, FOCAL_OF_WIDTH * width)


def ball_at(seconds: float) -> tuple[float, float, float]:
    """Return the ball's position at a time (s). It rolls back and forth at up to 0.46 m/s, 0.75 m from the robot."""
    return on_desk(0.75, 0.38 * math.sin(1.2 * seconds))


def scene_at(seconds: float) -> Scene:
    """Return the scene at a time (s), in slowly changing light."""
    light = 0.85 + 0.15 * math.sin(0.6 * seconds)
    return Scene(ball_at(seconds), boxes=BRICKS, light=light, cups=CUPS, plates=PLATES)


class ToyCamera(Node):
    """Publishes the camera's images. Passes `settings` to Node. The same seed produces the same images.

    Topics:
        /camera/image (sensor_msgs/Image): images of `width` by 3/4 `width` pixels, rgb8, best effort.

    Parameters:
        period_s (float): Time between two images, in seconds.
        width (int): Width of the images, in pixels: 160, 320, 480, or 640.
        seed (int): Seed of the sensor's noise.

    Raises:
        ValueError: The period is not a positive number, or the width is not one of these.
    """

    def __init__(self, **settings: Any) -> None:
        super().__init__("toy_camera", **settings)
        self.period_s: float = self.declare_parameter("period_s", PERIOD_S).value
        if not 0.0 < self.period_s < math.inf:
            raise ValueError(f"The period is the time between two pictures in seconds, not {self.period_s}.")
        width: int = self.declare_parameter("width", WIDTH).value
        if width not in (160, 320, 480, 640):
            raise ValueError(f"The width is 160, 320, 480 or 640, not {width}.")
        self.camera = DeskCamera(pinhole(width), self.declare_parameter("seed", SEED).value)
        self.count = 0
        self.publisher = self.create_publisher(Image, TOPIC, qos_profile_sensor_data)
        self.timer = self.create_timer(self.period_s, self.publish_picture)

    def publish_picture(self) -> None:
        """Render the current image, and publish it with the current time as its stamp."""
        image = Image(encoding="rgb8")
        image.header.stamp = self.get_clock().now().to_msg()
        image.header.frame_id = "head_camera_optical_frame"
        picture = self.camera.picture(scene_at(self.count * self.period_s), self.count)
        image.height, image.width = picture.shape[:2]
        image.step = 3 * image.width
        image.data = array("B", picture.tobytes())
        self.publisher.publish(image)
        self.count += 1


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(ToyCamera())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
