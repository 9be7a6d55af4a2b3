"""The camera of exercise 15, with images of 160 × 120 pixels. A ball rolls across the desk."""

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.parameter import Parameter

from lesson_nodes.head_camera import HeadCamera

WIDTH = 160


def main(args: list[str] | None = None) -> None:
    """Run the camera until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(HeadCamera(parameter_overrides=[Parameter("width", value=WIDTH)]))
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
