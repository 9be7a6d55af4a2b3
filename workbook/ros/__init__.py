"""Make ROS safe for notebooks, with domain leases, the environment, contexts and executors, and graph tools.

A *domain lease* reserves a ROS domain for one process. Every layer above may import these modules. Functions for cells
(`node_list`, `topic_echo`, …) are attributes of the package. They're imported on first use, because rclpy must not be
imported before the environment is set.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from workbook.ros.fresh_nodes import fresh
    from workbook.ros.notebook_registry import join_line
    from workbook.ros.session import Stopped, init, live, run, shutdown, spin_for
    from workbook.ros.tools import graph, node_info, node_list, topic_info, topic_list
    from workbook.ros.topic_monitor import topic_echo, topic_hz

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
    "topic_monitor": ("topic_echo", "topic_hz"),
    "notebook_registry": ("join_line",),
    "session": ("Stopped", "init", "live", "run", "shutdown", "spin_for"),
    "tools": ("graph", "node_info", "node_list", "topic_info", "topic_list"),
    "fresh_nodes": ("fresh",),
}


def __getattr__(name: str) -> Any:
    for module, names in _HOME.items():
        if name in names:
            return getattr(import_module(f"{__name__}.{module}"), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
