"""Watches a camera and a detector: how old detections are when they arrive, and where the boxes are by then.

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
    """The stamp of a header, in seconds."""
    return float(header.stamp.sec + header.stamp.nanosec / 1e9)


def to_detection(marker: Marker) -> Detection:
    """A marker as the detection that it was made of."""
    place, size = marker.pose.position, marker.scale
    return Detection(marker.ns, marker.color.a, place.x, place.y, size.x, size.y)


class ToyScope(Node):
    """Listens to a camera, to detections and to a heartbeat.

    Subscriptions:
        /camera/image (sensor_msgs/Image): pictures, rgb8 without padding.
        /robot/detections (visualization_msgs/MarkerArray): for a picture, a marker for each toy.
        /robot/heartbeat (std_msgs/String): "alive".

    Attributes:
        ages: For each message with detections, how long before its arrival the picture was taken (s).
        beats: When heartbeats arrived (s).
        detections: The detections of the last message.
        film: Every third picture, RGB, each with the detections that were the last ones then.
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
        """Keep every third picture, once there are detections."""
        self.count += 1
        if self.ages and self.count % FILM_EVERY == 0 and len(self.film) < FILM_LENGTH:
            picture = np.array(image.data, dtype=np.uint8).reshape(image.height, image.width, 3)
            self.film.append((picture, self.detections))

    def on_detections(self, message: MarkerArray) -> None:
        """Keep the detections, and write down how old they are."""
        self.detections = [to_detection(marker) for marker in message.markers]
        if message.markers:
            self.ages.append(time.time() - taken_at(message.markers[0].header))

    def on_beat(self, message: String) -> None:
        """Write down when a heartbeat came."""
        self.beats.append(time.monotonic())


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or a request to end, then leave with exit code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(ToyScope())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
