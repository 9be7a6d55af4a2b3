"""Record a camera's latest images, and the ball directions that another node publishes for them.

Run it with ``python -m lesson_nodes.ball_scope`` and end it with Ctrl-C.
"""

from collections import deque

import numpy as np
import numpy.typing as npt
import rclpy
from geometry_msgs.msg import Vector3Stamped
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image

Picture = npt.NDArray[np.uint8]
KEPT = 30
FILM_EVERY, FILM_LENGTH = 5, 60


class BallScope(Node):
    """Records a camera's images and a tracker's directions.

    Subscriptions:
        /camera/image (sensor_msgs/Image): images, rgb8.
        /robot/ball_direction (geometry_msgs/Vector3Stamped): direction of the ball; (0, 0, 0) if there is none.

    Attributes:
        pictures: The latest 30 images, as pairs of a stamp (s) and an RGB array.
        film: Every fifth image as an RGB array, at most 60 of them.
        directions: All directions, as pairs of a stamp (s) and a vector (x, y, z).
    """

    def __init__(self) -> None:
        super().__init__("ball_scope")
        self.pictures: deque[tuple[float, Picture]] = deque(maxlen=KEPT)
        self.film: list[Picture] = []
        self.count = 0
        self.directions: list[tuple[float, tuple[float, float, float]]] = []
        self.create_subscription(Image, "/camera/image", self.on_image, qos_profile_sensor_data)
        self.create_subscription(Vector3Stamped, "/robot/ball_direction", self.on_direction, 50)

    def on_image(self, image: Image) -> None:
        """Store an image, and add every fifth one to the film."""
        rows = np.array(image.data, dtype=np.uint8).reshape(image.height, image.step)
        picture = rows[:, : 3 * image.width].reshape(image.height, image.width, 3)
        stamp = image.header.stamp
        self.pictures.append((stamp.sec + stamp.nanosec / 1e9, picture))
        if self.count % FILM_EVERY == 0 and len(self.film) < FILM_LENGTH:
            self.film.append(picture)
        self.count += 1

    def on_direction(self, message: Vector3Stamped) -> None:
        """Record a direction."""
        stamp, vector = message.header.stamp, message.vector
        self.directions.append((stamp.sec + stamp.nanosec / 1e9, (vector.x, vector.y, vector.z)))


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(BallScope())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
