"""Find toys in images with a neural network that takes 0.2 s per image, and publish a heartbeat.

Run it with ``python -m lesson_nodes.toy_detector`` and end it with Ctrl-C.
"""

import queue
import threading
import time
from contextlib import suppress
from typing import Any

import numpy as np
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import QoSProfile, ReliabilityPolicy
from sensor_msgs.msg import Image
from std_msgs.msg import Header, String
from visualization_msgs.msg import Marker, MarkerArray

from workbook.models import DeskDetector, Detection

HEARTBEAT_PERIOD_S = 0.1
TAKES_S = 0.2
WHERE = ("callback", "thread")


def to_markers(detections: list[Detection], header: Header) -> MarkerArray:
    """Convert detections to markers: `ns` is the label, `color.a` is the score; position and scale are in pixels."""
    message = MarkerArray()
    for number, one in enumerate(detections):
        marker = Marker(header=header, ns=one.label, id=number)
        marker.pose.position.x, marker.pose.position.y = one.u, one.v
        marker.scale.x, marker.scale.y = one.width, one.height
        marker.color.a = one.score
        message.markers.append(marker)
    return message


class ToyDetector(Node):
    """Detects toys in images, in the callback or in a separate thread. Passes `settings` to Node.

    Topics:
        /robot/detections (visualization_msgs/MarkerArray): a message per image, with a marker for each toy.
        /robot/heartbeat (std_msgs/String): "alive", ten times a second.

    Subscriptions:
        /camera/image (sensor_msgs/Image): images, rgb8 without padding.

    Parameters:
        depth (int): The subscription's queue depth.
        where (str): Where the network runs, "callback" or "thread".
        takes_s (float): Time per image, in seconds. The node sleeps for the part that the network doesn't need.
        load_s (float): Extra time for loading the network, in seconds.
        loads_each_time (bool): A deliberate fault: the network is loaded again for each image.
        stamps_now (bool): A deliberate fault: detections are stamped with the time at which they are published.

    Raises:
        ValueError: `where` has another value, or the depth is below 1.
    """

    def __init__(self, **settings: Any) -> None:
        super().__init__("toy_detector", **settings)
        depth: int = self.declare_parameter("depth", 1).value
        where: str = self.declare_parameter("where", "callback").value
        if depth < 1 or where not in WHERE:
            raise ValueError(f"The depth is 1 or more and `where` one of {WHERE}, not {depth} and {where!r}.")
        self.takes_s: float = self.declare_parameter("takes_s", TAKES_S).value
        self.load_s: float = self.declare_parameter("load_s", 0.0).value
        loads_each_time: bool = self.declare_parameter("loads_each_time", False).value
        self.stamps_now: bool = self.declare_parameter("stamps_now", False).value
        self.detector = self.load()
        self.waiting: queue.Queue[Image | None] = queue.Queue(maxsize=1)
        self.worker = threading.Thread(target=self.work, daemon=True)
        self.publisher = self.create_publisher(MarkerArray, "/robot/detections", 10)
        self.heartbeat_publisher = self.create_publisher(String, "/robot/heartbeat", 10)
        self.create_timer(HEARTBEAT_PERIOD_S, self.beat)
        newest = QoSProfile(depth=depth, reliability=ReliabilityPolicy.BEST_EFFORT)
        in_callback = self.load_and_look if loads_each_time else self.look
        on_image = in_callback if where == "callback" else self.keep_newest
        self.create_subscription(Image, "/camera/image", on_image, newest)
        if where == "thread":
            self.worker.start()

    def load(self) -> DeskDetector:
        """Load the network, after a delay that simulates a larger one."""
        time.sleep(self.load_s)
        return DeskDetector()

    def beat(self) -> None:
        """Publish a heartbeat."""
        self.heartbeat_publisher.publish(String(data="alive"))

    def look(self, image: Image) -> None:
        """Find the toys in an image, and publish them with the image's header."""
        done = time.monotonic() + self.takes_s
        values = np.frombuffer(image.data, np.uint8)
        detections = self.detector(values.reshape(image.height, image.width, 3))
        time.sleep(max(0.0, done - time.monotonic()))  # simulates a larger network
        self.answer(detections, image.header)

    def answer(self, detections: list[Detection], header: Header) -> None:
        """Publish detections with their image's header."""
        if self.stamps_now:
            header.stamp = self.get_clock().now().to_msg()
        self.publisher.publish(to_markers(detections, header))

    def load_and_look(self, image: Image) -> None:
        """Load the network again for each image: a deliberate fault that lesson 16 shows."""
        self.detector = self.load()
        self.look(image)

    def keep_newest(self, image: Image) -> None:
        """Store an image for the thread. Discard the previous image if the thread hasn't taken it yet."""
        with suppress(queue.Empty):
            self.waiting.get_nowait()
        self.waiting.put_nowait(image)

    def work(self) -> None:
        """Process images, one after another, until `close` is called."""
        while (image := self.waiting.get()) is not None:
            try:
                self.look(image)
            except Exception as fault:
                if not self.context.ok():
                    return
                self.get_logger().error(f"The model failed: {fault}")

    def close(self) -> None:
        """End the thread, if there is one."""
        with suppress(queue.Empty):
            self.waiting.get_nowait()
        self.waiting.put(None)
        if self.worker.is_alive():
            self.worker.join()


def main(args: list[str] | None = None) -> None:
    """Run the node until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    node = ToyDetector()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.close()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
