"""Publish a burst of images as fast as possible, once there is a subscription.

Run it with ``python -m lesson_nodes.burst_camera`` and end it with Ctrl-C.
"""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from sensor_msgs.msg import Image

COUNT = 20
LARGE_BYTES = 640 * 480 * 3


class BurstCamera(Node):
    """Checks every 0.5 s for a subscription. Once it finds one, it publishes COUNT images in a row.

    Topics:
        /camera/burst (sensor_msgs/Image): `width` is the image's number, starting with 1.

    Parameters:
        depth (int): The publisher's queue depth.
        size_bytes (int): Size of each image, in bytes.
    """

    def __init__(self) -> None:
        super().__init__("burst_camera")
        depth = self.declare_parameter("depth", 10).value
        self.data = bytes(self.declare_parameter("size_bytes", LARGE_BYTES).value)
        self.image_publisher = self.create_publisher(Image, "/camera/burst", depth)
        self.wait_timer = self.create_timer(0.5, self.burst_once_matched)

    def burst_once_matched(self) -> None:
        """Publish all images once, if there is a subscription."""
        if self.image_publisher.get_subscription_count() == 0:
            return
        self.wait_timer.cancel()
        for number in range(1, COUNT + 1):
            self.image_publisher.publish(Image(width=number, data=self.data))


def main(args: list[str] | None = None) -> None:
    """Run the camera until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    camera = BurstCamera()
    try:
        rclpy.spin(camera)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        camera.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
