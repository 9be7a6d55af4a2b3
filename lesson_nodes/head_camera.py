"""The camera in the head of the humanoid: it sees its own hands, a ball, and the desk that it stands at.

Run it with ``python -m lesson_nodes.head_camera`` and end it with Ctrl-C.
"""

import math

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image
from std_msgs.msg import Float32MultiArray

from workbook.scenes.desk import DeskCamera
from workbook.scenes.encodings import encoded
from workbook.scenes.pinhole import Pinhole
from workbook.scenes.scene import Box, Scene, on_desk

PERIOD_S = 1 / 30
WIDTH = 640
SEED = 15
TOPIC = "/camera/image"
FOCAL_OF_WIDTH = 0.875
AT_REST = (0.0, 0.0, 0.8, 0.8, 0.8, 0.8, 0.06, 0.06, 0.0, 0.06, 0.06, 0.0)
BRICKS = (Box((1.05, 0.45), turn=0.4), Box((1.1, -0.5), turn=-0.5))


def pinhole(width: int) -> Pinhole:
    """The camera for pictures of that width, four to three."""
    return Pinhole(width, 3 * width // 4, FOCAL_OF_WIDTH * width)


def ball_at(seconds: float) -> tuple[float, float, float]:
    """Where the ball lies at a moment: it rolls to and fro, 0.75 m to 0.9 m before the robot."""
    return on_desk(0.82 + 0.08 * math.sin(0.5 * seconds), 0.42 * math.sin(0.9 * seconds))


def light_at(seconds: float) -> float:
    """How bright it is: clouds pass by."""
    return 0.75 + 0.3 * math.sin(0.6 * seconds)


class HeadCamera(Node):
    """Publishes what the robot sees. Each run with the same seed brings the same pictures.

    Topics:
        /camera/image (sensor_msgs/Image): pictures of `width` by 3/4 `width` pixels, best effort.

    Subscriptions:
        /robot/joint_positions (std_msgs/Float32MultiArray): 12 angles (rad). The neck turns the camera to the left;
            shoulders and elbows move the hands.

    Parameters:
        period_s (float): Time between two pictures, in seconds.
        width (int): Columns of a picture.
        encoding (str): rgb8, bgr8 or mono8.
        padding (int): Unused bytes at the end of each row.
        seed (int): Which noise the sensor has.

    Raises:
        ValueError: The period is not a positive number, or the width or the encoding is none that there is.
    """

    def __init__(
        self,
        period_s: float = PERIOD_S,
        width: int = WIDTH,
        encoding: str = "rgb8",
        padding: int = 0,
        seed: int = SEED,
    ) -> None:
        super().__init__("head_camera")
        period_s = self.declare_parameter("period_s", period_s).value
        if not 0.0 < period_s < math.inf:
            raise ValueError(f"The period is the time between two pictures in seconds, not {period_s}.")
        width = self.declare_parameter("width", width).value
        if not 16 <= width <= 1920 or width % 4:
            raise ValueError(f"The width is a multiple of 4 from 16 to 1920, not {width}.")
        self.encoding = self.declare_parameter("encoding", encoding).value
        if self.encoding not in ("rgb8", "bgr8", "mono8"):
            raise ValueError(f"The encoding is rgb8, bgr8 or mono8, not {self.encoding!r}.")
        self.padding = self.declare_parameter("padding", padding).value
        self.period_s = period_s
        self.camera = DeskCamera(pinhole(width), self.declare_parameter("seed", seed).value)
        self.joints: tuple[float, ...] = AT_REST
        self.count = 0
        self.image_publisher = self.create_publisher(Image, TOPIC, qos_profile_sensor_data)
        self.create_subscription(Float32MultiArray, "/robot/joint_positions", self.on_joints, 10)
        self.timer = self.create_timer(period_s, self.publish_picture)

    def on_joints(self, message: Float32MultiArray) -> None:
        """Move head and hands."""
        if len(message.data) == len(AT_REST) and all(map(math.isfinite, message.data)):
            self.joints = tuple(message.data)

    def publish_picture(self) -> None:
        """Publish what the camera sees now, with the time at which it saw it."""
        image = Image()
        image.header.stamp = self.get_clock().now().to_msg()
        image.header.frame_id = "head_camera_optical_frame"
        seconds = self.count * self.period_s
        scene = Scene(ball_at(seconds), None, BRICKS, self.joints, self.joints[0], light_at(seconds))
        picture = self.camera.picture(scene, self.count)
        image.data, image.step = encoded(picture, self.encoding, self.padding)
        image.height, image.width = picture.shape[:2]
        image.encoding = self.encoding
        self.image_publisher.publish(image)
        self.count += 1


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(HeadCamera())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
