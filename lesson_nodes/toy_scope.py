"""Record how old a detector's results are when they arrive, and how their boxes fit the current images.

Run it with ``python -m lesson_nodes.toy_scope`` and end it with Ctrl-C.
"""

import time

import numpy as np
import numpy.typing as npt
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image
from std_msgs.msg import Header, String
from visualization_msgs.msg import Marker, MarkerArray

from workbook.models import Detection

Picture = npt.NDArray[np.uint8]
FILM_EVERY, FILM_LENGTH = 3, 90


def taken_at(header: Header) -> float:
    """Return a header's stamp, in seconds."""
    return float(header.stamp.sec + header.stamp.nanosec / 1e9)


def to_detection(marker: Marker) -> Detection:
    """Convert a marker back to a detection."""
    place, size = marker.pose.position, marker.scale
    return Detection(marker.ns, marker.color.a, place.x, place.y, size.x, size.y)


class ToyScope(Node):
    """Records images, detections, and heartbeats.

    Subscriptions:
        /camera/image (sensor_msgs/Image): images, rgb8 without padding.
        /robot/detections (visualization_msgs/MarkerArray): a message per image, with a marker for each toy.
        /robot/heartbeat (std_msgs/String): "alive".

    Attributes:
        ages: For each message with detections, its image's age on arrival (s).
        beats: Arrival times of heartbeats (`time.monotonic`, s).
        detections: The detections in the latest message.
        film: Every third image as an RGB array, each with the latest detections at that time, at most 90 pairs.
    """

    def __init__(self) -> None:
        super().__init__("toy_scope")
        self.ages: list[float] = []
        self.beats: list[float] = []
        self.detections: list[Detection] = []
        self.film: list[tuple[Picture, list[Detection]]] = []
        self.count = 0
        self.create_subscription(Image, "/camera/image", self.on_image, qos_profile_sensor_data)
        self.create_subscription(MarkerArray, "/robot/detections", self.on_detections, 10)
        self.create_subscription(String, "/robot/heartbeat", self.on_beat, 50)

    def on_image(self, image: Image) -> None:
        """Add every third image to the film, once there are detections."""
        self.count += 1
        if self.ages and self.count % FILM_EVERY == 0 and len(self.film) < FILM_LENGTH:
            picture = np.array(image.data, dtype=np.uint8).reshape(image.height, image.width, 3)
            self.film.append((picture, self.detections))

    def on_detections(self, message: MarkerArray) -> None:
        """Store the detections, and record their image's age."""
        self.detections = [to_detection(marker) for marker in message.markers]
        if message.markers:
            self.ages.append(time.time() - taken_at(message.markers[0].header))

    def on_beat(self, message: String) -> None:
        """Record when a heartbeat arrived."""
        self.beats.append(time.monotonic())


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(ToyScope())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
