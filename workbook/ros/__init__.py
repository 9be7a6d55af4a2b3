"""ROS for notebooks: domains, the environment, nodes that run in a cell, logs, a look at the graph.

Names are imported when they are first used, because rclpy must not be imported before the environment is set.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from workbook.ros.presence import join_line
    from workbook.ros.session import Stopped, init, live, run, shutdown, spin_for
    from workbook.ros.twins import fresh

_HOME = {
    "Stopped": "session",
    "fresh": "twins",
    "init": "session",
    "join_line": "presence",
    "live": "session",
    "run": "session",
    "shutdown": "session",
    "spin_for": "session",
}

__all__ = ["Stopped", "fresh", "init", "join_line", "live", "run", "shutdown", "spin_for"]


def __getattr__(name: str) -> Any:
    if name in _HOME:
        return getattr(import_module(f"workbook.ros.{_HOME[name]}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
