"""ROS for notebooks: domains, the environment, nodes that run in a cell, logs, a look at the graph.

Names are imported when they are first used, because rclpy must not be imported before the environment is set.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from workbook.ros.listening import topic_echo, topic_hz
    from workbook.ros.presence import join_line
    from workbook.ros.session import Stopped, init, live, run, shutdown, spin_for
    from workbook.ros.tools import graph, node_info, node_list, topic_info, topic_list
    from workbook.ros.twins import fresh

__all__ = [
    "Stopped",
    "fresh",
    "graph",
    "init",
    "join_line",
    "live",
    "node_info",
    "node_list",
    "run",
    "shutdown",
    "spin_for",
    "topic_echo",
    "topic_hz",
    "topic_info",
    "topic_list",
]

_HOME = {
    "listening": ("topic_echo", "topic_hz"),
    "presence": ("join_line",),
    "session": ("Stopped", "init", "live", "run", "shutdown", "spin_for"),
    "tools": ("graph", "node_info", "node_list", "topic_info", "topic_list"),
    "twins": ("fresh",),
}


def __getattr__(name: str) -> Any:
    for module, names in _HOME.items():
        if name in names:
            return getattr(import_module(f"{__name__}.{module}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
