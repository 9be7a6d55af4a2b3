"""Simulate a camera driver as a vendor might ship it: the node's name is built in.

Run it with ``python -m lesson_nodes.camera_driver`` and end it with Ctrl-C. To change the node's name
and its namespace, add ``--ros-args -r __node:=left_camera -r __ns:=/robot``.
"""

from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String

FRAME_PERIOD_S = 0.5
REPORT_PERIOD_S = 1.0


class CameraDriver(Node):
    """Publishes simulated images and fault reports. Passes `settings` to Node, such as namespace or cli_args.

    Topics, for a node /robot/camera:
        /robot/camera/frame (std_msgs/String), 2 Hz: the image's number, instead of an image.
        /robot/faults (std_msgs/String), 1 Hz: the camera's name and its faults.
    """

    def __init__(self, **settings: Any) -> None:
        super().__init__("camera", **settings)
        self.frames = 0
        self.frame_publisher = self.create_publisher(String, "~/frame", 10)
        self.fault_publisher = self.create_publisher(String, "faults", 10)
        self.create_timer(FRAME_PERIOD_S, self.take_picture)
        self.create_timer(REPORT_PERIOD_S, self.report_faults)
        self.get_logger().info("Camera started")

    def take_picture(self) -> None:
        """Publish the next image's number."""
        self.frames += 1
        self.frame_publisher.publish(String(data=f"picture {self.frames}"))

    def report_faults(self) -> None:
        """Report this camera's faults."""
        self.fault_publisher.publish(String(data=f"{self.get_name()}: none"))


def main(args: list[str] | None = None) -> None:
    """Run the driver until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(CameraDriver())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
