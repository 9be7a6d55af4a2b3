"""ROS log lines that stand between the prints where they belong.

rclpy itself writes a log line to the stderr of the process, behind Python's back: a notebook shows it late,
in another order each time, and not at all under pytest. Here the line of a Python logger is printed by
Python, while /rosout gets it from ROS as always. Log lines of the C libraries keep their way to stderr.
"""

import ctypes
import sys
import threading
from typing import Any

from rclpy.impl.implementation_singleton import rclpy_implementation as _rclpy

_LEVELS = {10: "DEBUG", 20: "INFO", 30: "WARN", 40: "ERROR", 50: "FATAL"}
_COLORS = {10: "38;2;120;120;120", 30: "38;2;176;106;0", 40: "38;2;220;59;59", 50: "1;38;2;220;59;59"}


def format_line(severity: int, name: str, message: str) -> str:
    """One log line without a time stamp; the word of a level other than INFO has a color."""
    level = _LEVELS.get(severity, str(severity))
    if severity in _COLORS:
        level = f"\x1b[{_COLORS[severity]}m{level}\x1b[0m"
    return f"[{level}] [{name}]: {message}"


class _Rosout:
    """Sends log lines of this thread to /rosout only, for as long as it is entered."""

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
    """Print the lines of Python loggers from now on; safe to call again.

    Returns False, and leaves logging as it is, where the ROS libraries do not offer what is needed.
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
