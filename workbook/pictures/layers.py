"""Draw the layers of ROS 2: a Python node next to a C++ node, from their own code down to the network."""

from typing import Any

from matplotlib.figure import Figure
from matplotlib.patches import FancyBboxPatch

from workbook.pictures.figures import figure
from workbook.pictures.palette import BLUE, GREEN, GREY

DESCRIPTION = (
    "two nodes, layer by layer. Left: Python code, rclpy, rcl, rmw, DDS. Right: C++ code, rclcpp, rcl, rmw, DDS. "
    "The lower three are the same on both sides. Messages go from DDS to DDS"
)
LAYERS = (
    ("Python code", "C++ code", "decides what the robot does"),
    ("rclpy", "rclcpp", "nodes, timers and messages, as fits the language"),
    ("rcl", "rcl", "the common core, in C: the same rules for all"),
    ("rmw", "rmw", "the interface that each middleware implements"),
    ("DDS", "DDS", "finds other programs, carries messages (here Fast DDS)"),
)
WIDTH, HEIGHT = 2.1, 0.7
LEFT, RIGHT = 0.0, 3.0
OF_A_LANGUAGE = 2
"""The number of upper layers that are specific to each language."""


def layers() -> Figure:
    """Draw the layers and return the figure. `DESCRIPTION` is its alternative text."""
    fig, axes = figure(6.6, 3.0)
    for row, (left, right, what) in enumerate(LAYERS):
        bottom = float(len(LAYERS) - row)
        color = BLUE if row < OF_A_LANGUAGE else GREEN
        for place, name in ((LEFT, left), (RIGHT, right)):
            _box(axes, place, bottom, name, color)
        axes.text(RIGHT + WIDTH + 0.2, bottom + HEIGHT / 2, what, va="center", fontsize=9)
    _wire(axes)
    axes.set(xlim=(-0.1, 10.2), ylim=(0.2, len(LAYERS) + 1.0), title="Two languages, one core: rcl and below")
    axes.axis("off")
    return fig


def _box(axes: Any, left: float, bottom: float, name: str, color: str) -> None:
    axes.add_patch(
        FancyBboxPatch(
            (left, bottom),
            WIDTH,
            HEIGHT,
            boxstyle="round,pad=0.04",
            facecolor="none",
            edgecolor=color,
            linewidth=1.8,
        )
    )
    axes.text(left + WIDTH / 2, bottom + HEIGHT / 2, name, ha="center", va="center")


def _wire(axes: Any) -> None:
    """Draw the arrow from DDS to DDS with its label."""
    arrow = {"arrowstyle": "<->", "color": GREY, "linewidth": 1.6}
    middle = 1.0 + HEIGHT / 2
    axes.annotate("", xy=(LEFT + WIDTH + 0.06, middle), xytext=(RIGHT - 0.06, middle), arrowprops=arrow)
    axes.text((LEFT + WIDTH + RIGHT) / 2, middle - 0.55, "messages", ha="center", va="center", fontsize=9)
