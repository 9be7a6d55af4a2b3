"""Draw a robot program: the humanoid, a dashboard, timelines, and the graph, live and as stills.

Lessons and the layers above use the modules and names offered here::

    from workbook import pictures
    pictures.show(pictures.humanoid.draw(angles), "humanoid, 12 joints")

Modules that need matplotlib are imported on first use.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from workbook.pictures import dashboard, graph, humanoid, joints, marks, palette, png, timeline
    from workbook.pictures.figures import figure, render, show, still, style
    from workbook.pictures.joints import JOINT_NAMES, Follower
    from workbook.pictures.live import LiveFigure, LiveStill, animate
    from workbook.pictures.stills import Still

__all__ = [
    "JOINT_NAMES",
    "Follower",
    "LiveFigure",
    "LiveStill",
    "Still",
    "animate",
    "dashboard",
    "figure",
    "graph",
    "humanoid",
    "joints",
    "marks",
    "palette",
    "png",
    "render",
    "show",
    "still",
    "style",
    "timeline",
]

_HOME = {
    "JOINT_NAMES": "joints",
    "Follower": "joints",
    "LiveFigure": "live",
    "LiveStill": "live",
    "Still": "stills",
    "animate": "live",
    "figure": "figures",
    "render": "figures",
    "show": "figures",
    "still": "figures",
    "style": "figures",
}


def __getattr__(name: str) -> Any:
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    module = import_module(f"{__name__}.{_HOME.get(name, name)}")
    value = getattr(module, name) if name in _HOME else module
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
