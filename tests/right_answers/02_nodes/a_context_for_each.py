"""Two cameras on one robot, in front and in the back, with one driver."""

import sys
from typing import Any

import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
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


def start(*rules: str) -> tuple[SingleThreadedExecutor, Node]:
    """One camera in a context with arguments of its own."""
    context = Context()
    words = [word for rule in rules for word in ("-r", rule)]
    rclpy.init(context=context, args=[*sys.argv, "--ros-args", *words])
    camera = CameraDriver(context=context)
    executor = SingleThreadedExecutor(context=context)
    executor.add_node(camera)
    return executor, camera


def main() -> None:
    pairs = [start("__ns:=/robot"), start("__ns:=/robot", "__node:=rear_camera")]
    try:
        while all(camera.context.ok() for _, camera in pairs):
            for executor, _ in pairs:
                executor.spin_once(timeout_sec=0.005)
    except KeyboardInterrupt:
        pass
    finally:
        for _, camera in pairs:
            camera.destroy_node()
            camera.context.try_shutdown()


if __name__ == "__main__":
    main()
