"""A camera over a desk with toys: a ball rolls past a cup, a plate and a brick, all of them orange.

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
    """The camera for pictures of that width, four to three."""
    return Pinhole(width, 3 * width // 4, FOCAL_OF_WIDTH * width)


def ball_at(seconds: float) -> tuple[float, float, float]:
    """Where the ball lies at a moment: it rolls to and fro, 0.75 m before the robot, with up to 0.45 m/s."""
    return on_desk(0.75, 0.38 * math.sin(1.2 * seconds))


def scene_at(seconds: float) -> Scene:
    """What there is to see at a moment, in light that changes slowly."""
    light = 0.85 + 0.15 * math.sin(0.6 * seconds)
    return Scene(ball_at(seconds), boxes=BRICKS, light=light, cups=CUPS, plates=PLATES)


class ToyCamera(Node):
    """Publishes what the camera sees; `settings` go to the Node. The same seed brings the same pictures.

    Topics:
        /camera/image (sensor_msgs/Image): pictures of `width` by 3/4 `width` pixels, rgb8, best effort.

    Parameters:
        period_s (float): Time between two pictures, in seconds.
        width (int): Columns of a picture, a multiple of 160.
        seed (int): Which noise the sensor has.

    Raises:
        ValueError: The period is not a positive number, or the width is none that there is.
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
        """Publish what the camera sees now, with the time at which it saw it."""
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
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(ToyCamera())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
