"""The way of a robot on the floor that obeys commands of speed and turning, and a drawing of it."""

import math
from collections.abc import Iterable, Mapping
from typing import Any

from workbook.pictures.figures import figure, show
from workbook.pictures.palette import BLUE, GREY

Points = tuple[list[float], list[float]]
"""Two lists of equal length: x and y, in m."""


def path_of(twists: Iterable[Mapping[str, Any]], period_s: float = 0.1) -> Points:
    """Where the robot gets if it obeys each command for `period_s` s. At the start it looks up the page.

    `twists`: messages of type Twist as mappings, with linear x in m/s and angular z in rad/s.
    """
    x, y, heading = 0.0, 0.0, math.pi / 2
    xs, ys = [x], [y]
    for twist in twists:
        heading += period_s * twist["angular"]["z"]
        x += period_s * twist["linear"]["x"] * math.cos(heading)
        y += period_s * twist["linear"]["x"] * math.sin(heading)
        xs.append(x)
        ys.append(y)
    return xs, ys


def show_path(points: Points, description: str, title: str = "") -> None:
    """Draw the way of the robot in the cell, with its start and its end."""
    xs, ys = points
    fig, axes = figure(5.2, 2.8)
    axes.plot(xs, ys, color=BLUE)
    for place, mark, word in ((0, "o", "start"), (-1, "x", "end")):
        axes.plot(xs[place], ys[place], mark, color=GREY, markersize=9, markeredgewidth=2, fillstyle="none")
        axes.annotate(
            word, (xs[place], ys[place]), xytext=(8, 10 if place else -16), textcoords="offset points"
        )
    axes.set(xlabel="x (m)", ylabel="y (m)", aspect="equal", title=title)
    show(fig, description)
