"""Two cameras on one robot, in front and in the back, with one driver."""

import signal
import subprocess
import sys
from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from std_msgs.msg import String


class CameraDriver(Node):
    """The driver of the manufacturer, version 3.1. Please do not edit: updates replace this class.

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


def run(rules: list[str]) -> None:
    """One camera in this process, with its arguments as from a command line."""
    rclpy.init(args=[*sys.argv, "--ros-args", *rules])
    try:
        rclpy.spin(CameraDriver())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


def main() -> None:
    if "rear" in sys.argv[1:]:
        sys.argv.remove("rear")
        run(["-r", "__ns:=/robot", "-r", "__node:=rear_camera"])
        return
    rear = subprocess.Popen([sys.executable, __file__, "rear", *sys.argv[1:]])
    try:
        run(["-r", "__ns:=/robot"])
    finally:
        rear.send_signal(signal.SIGINT)
        rear.wait()


if __name__ == "__main__":
    main()
