"""Compare three ways to write a main function. Run one with ``python -m lesson_nodes.three_mains first_main``."""

import sys

import rclpy
from rclpy.executors import ExternalShutdownException

from lesson_nodes.night_guard import NightGuard


def first_main() -> None:
    """Park the arms after spin, then call shutdown."""
    rclpy.init()
    guard = NightGuard()
    rclpy.spin(guard)
    guard.park()
    guard.destroy_node()
    rclpy.shutdown()


def second_main() -> None:
    """Park the arms in finally, then call shutdown."""
    rclpy.init()
    guard = NightGuard()
    try:
        rclpy.spin(guard)
    except KeyboardInterrupt:
        pass
    finally:
        guard.park()
        guard.destroy_node()
        rclpy.shutdown()


def third_main() -> None:
    """Park the arms in finally, then call try_shutdown."""
    rclpy.init()
    guard = NightGuard()
    try:
        rclpy.spin(guard)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        guard.park()
        guard.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    {"first_main": first_main, "second_main": second_main, "third_main": third_main}[sys.argv[1]]()
