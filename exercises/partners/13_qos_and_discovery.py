"""The robot that exercise 13's dashboard watches. It publishes heartbeats for 5 s, and then pauses for 4 s."""

import rclpy
from rclpy.executors import ExternalShutdownException

from lesson_nodes.heartbeat import Heartbeat

BEATS_FOR_S, SILENT_FOR_S = 5.0, 4.0


def main(args: list[str] | None = None) -> None:
    """Run the robot until Ctrl-C or SIGTERM, then exit with code 0."""
    rclpy.init(args=args)
    try:
        rclpy.spin(Heartbeat(BEATS_FOR_S, SILENT_FOR_S))
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()
