"""Simulate a camera of 16 by 12 pixels whose images show a ball that rolls across the floor.

Run it with ``python -m lesson_nodes.tiny_camera`` and end it with Ctrl-C.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Image

WIDTH, HEIGHT = 16, 12
PERIOD_S = 0.5
STEP_PIXELS = 2
BALL_RADIUS = 2
BALL_ROW = 8
WALL = (150, 190, 230)
FLOOR = (120, 120, 110)
BALL = (220, 60, 40)


def pixel(column: int, row: int, ball_column: int) -> tuple[int, int, int]:
    """Return one pixel's color: red, green, and blue, each from 0 to 255."""
    if (column - ball_column) ** 2 + (row - BALL_ROW) ** 2 <= BALL_RADIUS**2:
        return BALL
    return FLOOR if row >= BALL_ROW else WALL


def picture(ball_column: int) -> Image:
    """Return the scene as a message: rows from top to bottom, pixels from left to right, three bytes per pixel."""
    image = Image()
    image.header.frame_id = "camera"
    image.width = WIDTH
    image.height = HEIGHT
    image.encoding = "rgb8"
    image.step = 3 * WIDTH
    image.data = [
        part for row in range(HEIGHT) for column in range(WIDTH) for part in pixel(column, row, ball_column)
    ]
    return image


class TinyCamera(Node):
    """Publishes an image twice a second.

    Topics:
        /robot/camera (sensor_msgs/Image), 2 Hz: 16 by 12 pixels, rgb8.
    """

    def __init__(self) -> None:
        super().__init__("tiny_camera")
        self.ball_column = 0
        self.image_publisher = self.create_publisher(Image, "/robot/camera", 1)
        self.create_timer(PERIOD_S, self.publish_picture)

    def publish_picture(self) -> None:
        """Publish the current image, stamped with the current time. Then move the ball."""
        image = picture(self.ball_column)
        image.header.stamp = self.get_clock().now().to_msg()
        self.image_publisher.publish(image)
        self.ball_column = (self.ball_column + STEP_PIXELS) % WIDTH


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(TinyCamera())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
