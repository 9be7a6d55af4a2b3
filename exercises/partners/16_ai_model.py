"""The camera and the IMU of exercise 16's robot. The robot watches toys on a desk, is pushed twice, and then falls."""

import math
import random
from array import array

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Image, Imu

from workbook.scenes.desk import DeskCamera
from workbook.scenes.pinhole import Pinhole
from workbook.scenes.scene import Box, Cup, Plate, Scene, on_desk

CAMERA_PERIOD_S, IMU_PERIOD_S = 1 / 30, 1 / 50
WIDTH, HEIGHT, FOCAL = 160, 120, 140.0  # pixels
BRICKS = (Box((1.05, 0.42), turn=0.5), Box((1.35, 0.1), turn=-0.4))
CUPS = (Cup((1.08, -0.12)),)
PLATES = (Plate((1.12, -0.5)),)
GRAVITY = 9.81
NOISE = 0.15  # standard deviation of an acceleration (m/s²)
PUSHES = {200: 70.0, 450: 80.0}  # sample number: the robot's tilt (°) for `PUSHED_SAMPLES` samples
PUSHED_SAMPLES = 8  # too few for a fall
FALLS_AFTER, FALLEN_DEG = 750, 85.0


class RobotSensors(Node):
    """Publishes the camera's images and the IMU's samples. Once the robot has fallen, it stays down.

    Topics:
        /camera/image (sensor_msgs/Image): 30 images per second, bgr8.
        /robot/imu (sensor_msgs/Imu): 50 samples per second. At rest, the acceleration points up.
    """

    def __init__(self, seed: int = 16) -> None:
        super().__init__("robot_sensors")
        self.camera = DeskCamera(Pinhole(WIDTH, HEIGHT, FOCAL), seed)
        self.dice = random.Random(seed)
        self.images = self.samples = 0
        self.image_publisher = self.create_publisher(Image, "/camera/image", 100)
        self.imu_publisher = self.create_publisher(Imu, "/robot/imu", 100)
        self.create_timer(CAMERA_PERIOD_S, self.publish_image)
        self.create_timer(IMU_PERIOD_S, self.publish_sample)

    def publish_image(self) -> None:
        """Publish the current image. The ball rolls from side to side."""
        seconds = self.images * CAMERA_PERIOD_S
        ball = on_desk(0.75, 0.38 * math.sin(1.2 * seconds))
        picture = self.camera.picture(Scene(ball, boxes=BRICKS, cups=CUPS, plates=PLATES), self.images)
        image = Image(encoding="bgr8", width=WIDTH, height=HEIGHT, step=3 * WIDTH)
        image.header.stamp = self.get_clock().now().to_msg()
        image.header.frame_id = "head_camera_optical_frame"
        image.data = array("B", picture[:, :, ::-1].tobytes())
        self.image_publisher.publish(image)
        self.images += 1

    def tilt_deg(self) -> float:
        """Return the robot's tilt to its left (°) at the next sample."""
        if self.samples >= FALLS_AFTER:
            return FALLEN_DEG
        pushes = (deg for first, deg in PUSHES.items() if 0 <= self.samples - first < PUSHED_SAMPLES)
        return next(pushes, 0.0)

    def publish_sample(self) -> None:
        """Publish the current acceleration."""
        tilt = math.radians(self.tilt_deg())
        sample = Imu()
        sample.header.stamp = self.get_clock().now().to_msg()
        sample.header.frame_id = "imu_link"
        up = sample.linear_acceleration
        up.x = self.dice.gauss(0.0, NOISE)
        up.y = -GRAVITY * math.sin(tilt) + self.dice.gauss(0.0, NOISE)
        up.z = GRAVITY * math.cos(tilt) + self.dice.gauss(0.0, NOISE)
        self.imu_publisher.publish(sample)
        self.samples += 1


def main(args: list[str] | None = None) -> None:
    """Run the sensors until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(RobotSensors())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
