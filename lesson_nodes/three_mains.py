"""Three ways to end a program, of which one is right. Run one with ``python -m lesson_nodes.three_mains hopeful``."""

import sys

import rclpy
from rclpy.executors import ExternalShutdownException

from lesson_nodes.night_guard import NightGuard


def hopeful() -> None:
    """Park the arms in the lines after spin."""
    rclpy.init()
    guard = NightGuard()
    rclpy.spin(guard)
    guard.park()
    guard.destroy_node()
    rclpy.shutdown()


def careful() -> None:
    """Catch Ctrl-C, and clean up in finally."""
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


def seasoned() -> None:
    """Expect both exceptions, and shut down only what is still up."""
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
    {"hopeful": hopeful, "careful": careful, "seasoned": seasoned}[sys.argv[1]]()
