"""Print ROS log lines in the right order with other output.

rclpy writes log lines to the process's stderr, bypassing Python. A notebook shows these lines late and in varying
order, and pytest doesn't show them at all. With this module, Python prints the lines that Python code logs through
rclpy, while ROS still sends them to /rosout. Log lines from the C libraries still go to stderr.
"""

import ctypes
import sys
import threading
from typing import Any

from rclpy.impl.implementation_singleton import rclpy_implementation as _rclpy

_LEVELS = {10: "DEBUG", 20: "INFO", 30: "WARN", 40: "ERROR", 50: "FATAL"}
_COLORS = {10: "38;2;120;120;120", 30: "38;2;176;106;0", 40: "38;2;220;59;59", 50: "1;38;2;220;59;59"}


def format_line(severity: int, name: str, message: str) -> str:
    """Format a log line without a timestamp. Levels other than INFO are colored."""
    level = _LEVELS.get(severity, str(severity))
    if severity in _COLORS:
        level = f"\x1b[{_COLORS[severity]}m{level}\x1b[0m"
    return f"[{level}] [{name}]: {message}"


class _Rosout:
    """A context manager in which ROS sends log lines only to /rosout."""

    def __init__(self) -> None:
        rcutils = ctypes.CDLL(_library("rcutils"))
        self._get = rcutils.rcutils_logging_get_output_handler
        self._get.restype = ctypes.c_void_p
        self._set = rcutils.rcutils_logging_set_output_handler
        self._set.argtypes = [ctypes.c_void_p]
        self._set.restype = None
        handler = ctypes.CDLL(_library("rcl")).rcl_logging_rosout_output_handler
        self._rosout_only = ctypes.cast(handler, ctypes.c_void_p).value
        self._lock = threading.RLock()
        self._before: list[int | None] = []

    def __enter__(self) -> None:
        self._lock.acquire()
        self._before.append(self._get())
        self._set(self._rosout_only)

    def __exit__(self, *exception: object) -> None:
        self._set(self._before.pop())
        self._lock.release()


def _library(name: str) -> str:
    return f"lib{name}.dylib" if sys.platform == "darwin" else f"lib{name}.so"


def install() -> bool:
    """Print the lines that Python code logs through rclpy, from now on. It's safe to call this function again.

    Return False, without changing anything, if the ROS libraries lack a required function.
    """
    original = _rclpy.rclpy_logging_rcutils_log
    if getattr(original, "prints_lines", False):
        return True
    try:
        rosout_only = _Rosout()
    except (OSError, AttributeError):
        return False

    def log(severity: Any, name: str, message: str, *place: Any) -> None:
        if not _rclpy.rclpy_logging_logger_is_enabled_for(name, severity):
            return
        with rosout_only:
            original(severity, name, message, *place)
        sys.stdout.write(format_line(int(severity), name, message) + "\n")

    log.prints_lines = True  # type: ignore[attr-defined]
    _rclpy.rclpy_logging_rcutils_log = log
    return True
