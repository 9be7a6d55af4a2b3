"""The driver is copied: the rear camera has a class of its own."""

from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import String


class CameraDriver(Node):
    """The driver of the manufacturer, version 3.1. The next update replaces this class.

    `settings` go to the Node as they are: namespace, cli_args and so on.
    """

    def __init__(self, **settings: Any) -> None:
        super().__init__("camera", **settings)
        self.frames = 0
        self.frame_publisher = self.create_publisher(String, "~/frame", 10)
        self.fault_publisher = self.create_publisher(String, "faults", 10)
        self.create_timer(0.5, self.take_picture)
        self.create_timer(1.0, self.report_faults)

    def take_picture(self) -> None:
        """Publish the next picture."""
        self.frames += 1
        self.frame_publisher.publish(String(data=f"picture {self.frames}"))

    def report_faults(self) -> None:
        """Say what is wrong with this camera."""
        self.fault_publisher.publish(String(data=f"{self.get_name()}: none"))


class RearCameraDriver(Node):
    """A copy of the driver, with another name.

    `settings` go to the Node as they are: namespace, cli_args and so on.
    """

    def __init__(self, **settings: Any) -> None:
        super().__init__("rear_camera", **settings)
        self.frames = 0
        self.frame_publisher = self.create_publisher(String, "~/frame", 10)
        self.fault_publisher = self.create_publisher(String, "faults", 10)
        self.create_timer(0.5, self.take_picture)
        self.create_timer(1.0, self.report_faults)

    def take_picture(self) -> None:
        """Publish the next picture."""
        self.frames += 1
        self.frame_publisher.publish(String(data=f"picture {self.frames}"))

    def report_faults(self) -> None:
        """Say what is wrong with this camera."""
        self.fault_publisher.publish(String(data=f"{self.get_name()}: none"))


def make_cameras() -> list[Node]:
    """Make /robot/camera and /robot/rear_camera."""
    front = CameraDriver(namespace="/robot")
    rear = RearCameraDriver(namespace="/robot")
    return [front, rear]


def main(args: list[str] | None = None) -> None:
    """Let the cameras work until Ctrl-C."""
    rclpy.init(args=args)
    executor = SingleThreadedExecutor()
    for camera in make_cameras():
        executor.add_node(camera)
    try:
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
