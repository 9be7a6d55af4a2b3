"""Compute and draw the path on the floor of a robot that follows velocity commands."""

import math
from collections.abc import Iterable, Mapping
from typing import Any

from workbook.pictures.figures import figure, show
from workbook.pictures.palette import BLUE, GREY

Points = tuple[list[float], list[float]]
"""Two lists of equal length: x (forward) and y (to the left), in m, as in REP 103."""


def path_of(twists: Iterable[Mapping[str, Any]], period_s: float = 0.1) -> Points:
    """Return the path of a robot that follows each command for `period_s` seconds. It starts at (0, 0), facing along x.

    `twists`: Twist messages as mappings, with linear x in m/s and angular z in rad/s.
    """
    x, y, heading = 0.0, 0.0, 0.0
    xs, ys = [x], [y]
    for twist in twists:
        heading += period_s * twist["angular"]["z"]
        x += period_s * twist["linear"]["x"] * math.cos(heading)
        y += period_s * twist["linear"]["x"] * math.sin(heading)
        xs.append(x)
        ys.append(y)
    return xs, ys


def show_path(points: Points, description: str, title: str = "") -> None:
    """Draw the robot's path in the cell, with its start and end: x points up the page, and y to the left."""
    xs, ys = points
    fig, axes = figure(5.2, 2.8)
    axes.plot(ys, xs, color=BLUE)
    for place, mark, word in ((0, "o", "start"), (-1, "x", "end")):
        axes.plot(ys[place], xs[place], mark, color=GREY, markersize=9, markeredgewidth=2, fillstyle="none")
        axes.annotate(
            word, (ys[place], xs[place]), xytext=(8, 10 if place else -16), textcoords="offset points"
        )
    axes.set(xlabel="y, to the left (m)", ylabel="x, forward (m)", aspect="equal", title=title)
    axes.invert_xaxis()
    axes.margins(0.2)
    show(fig, description)
