"""Draw figures about a camera: an image's memory layout, the hue wheel, the pinhole model, and images side by side."""

import colorsys
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Rectangle, Wedge

from workbook.pictures.figures import figure
from workbook.pictures.palette import AMBER, BLUE, GREEN, GREY, RED, TEXT
from workbook.pictures.png import Pixels

HUES = 180
"""OpenCV's hues for uint8 images: half of the angle in degrees."""
_LOOKS: dict[str, Any] = {"ha": "center", "va": "center"}


@dataclass(frozen=True)
class Ring:
    """A circle to draw on an image, with its label. Center and radius are in pixels of the image."""

    column: float
    row: float
    radius: float
    label: str
    is_right: bool


def side_by_side(
    images: Sequence[Pixels], titles: Sequence[str], *, rings: Sequence[Ring] = (), height: float = 2.6
) -> Figure:
    """Draw images next to each other, each with its title above. `rings` are drawn on every image.

    `height`: the figure's height in inches.
    """
    width = sum(image.shape[1] / image.shape[0] for image in images) * height
    fig, axes = figure(width, height + 0.3, columns=len(images))
    for axis, image, title in zip(np.atleast_1d(axes), images, titles, strict=True):
        axis.imshow(image, cmap="gray", interpolation="nearest")
        axis.set_title(title, fontsize=11)
        axis.set_axis_off()
        for ring in rings:
            _draw_ring(axis, ring, image.shape[0])
    return fig


def _draw_ring(axis: Any, ring: Ring, height: int) -> None:
    line = "-" if ring.is_right else "--"
    axis.add_patch(Circle((ring.column, ring.row), ring.radius, fill=False, color="white", lw=2.2, ls=line))
    below = ring.row + ring.radius + 0.06 * height
    backing = {"facecolor": "#1b2733", "edgecolor": "none", "pad": 2.5}
    axis.text(ring.column, below, ring.label, color="white", fontsize=10, bbox=backing, **_LOOKS)


def row_memory(width: int, step: int) -> Figure:
    """Draw two rows of an rgb8 image in memory, as stored in `data`: the pixels, then the padding.

    `width`: pixels per row. `step`: bytes per row.
    """
    fig, axis = figure(7.6, 1.9)
    axis.set(xlim=(-0.2, 26.6), ylim=(-1.1, 4.2))
    axis.set_axis_off()
    for first in (0.0, 13.4):
        place = first
        for letter, color in 2 * (("R", RED), ("G", GREEN), ("B", BLUE)):
            _byte(axis, place, letter, color)
            place += 1
        axis.text(place + 0.75, 0.5, "…", color=TEXT, fontsize=13, **_LOOKS)
        place += 1.5
        for letter, color in (("R", RED), ("G", GREEN), ("B", BLUE)):
            _byte(axis, place, letter, color)
            place += 1
        axis.add_patch(Rectangle((place, 0), 2.4, 1, facecolor="none", edgecolor=GREY, hatch="////", lw=1))
        _bracket(axis, first, place, 1.2, f"3 · width = {3 * width} bytes of pixels")
        _bracket(axis, first, place + 2.4, 2.8, f"step = {step} bytes")
        axis.text(place + 1.2, -0.6, f"{step - 3 * width} unused", color=TEXT, fontsize=9, **_LOOKS)
        axis.text(first + 3, -0.6, f"row {int(first > 0)}", color=TEXT, fontsize=9, **_LOOKS)
    axis.set_title(f"In data, each row begins {step} bytes after the one before", fontsize=11)
    return fig


def _byte(axis: Any, place: float, letter: str, color: str) -> None:
    axis.add_patch(Rectangle((place, 0), 1, 1, facecolor=color, edgecolor="white", lw=0.8))
    axis.text(place + 0.5, 0.47, letter, color="white", fontsize=10, weight="bold", **_LOOKS)


def _bracket(axis: Any, start: float, end: float, height: float, words: str) -> None:
    tick = 0.25
    xs, ys = [start, start, end, end], [height, height + tick, height + tick, height]
    axis.plot(xs, ys, color=GREY, lw=1.4)
    axis.text((start + end) / 2, height + 0.75, words, color=TEXT, fontsize=9, **_LOOKS)


def hue_wheel(low: int, high: int) -> Figure:
    """Draw the hue wheel with OpenCV's numbers, 0 to 179, and mark the accepted range from `low` to `high`."""
    fig, axis = figure(3.6, 3.4)
    axis.set(xlim=(-1.55, 1.75), ylim=(-1.4, 1.45), aspect="equal")
    axis.set_axis_off()
    for hue in range(HUES):
        color = colorsys.hsv_to_rgb(hue / HUES, 0.9, 0.95)
        axis.add_patch(Wedge((0, 0), 1.0, 2 * hue, 2 * hue + 2.4, width=0.38, facecolor=color, lw=0))
    axis.add_patch(
        Wedge((0, 0), 1.1, 2 * low, 2 * high, width=0.58, facecolor="none", edgecolor=AMBER, lw=2.6)
    )
    for hue in range(0, HUES, 30):
        angle = math.radians(2 * hue)
        axis.text(1.25 * math.cos(angle), 1.25 * math.sin(angle), str(hue), color=TEXT, fontsize=10, **_LOOKS)
    middle = math.radians(low + high)
    axis.annotate(
        f"{low} to {high}:\norange",
        (0.5 * math.cos(middle), 0.5 * math.sin(middle)),
        (0, 0),
        color=TEXT,
        fontsize=10,
        ha="center",
        va="center",
    )
    axis.set_title("The accepted hues are a small slice", fontsize=11)
    return fig


def pinhole_above(focal: float, offset: float) -> Figure:
    """Draw the pinhole model from above, with a ball to the right, and the triangle that determines its angle.

    `focal`: the focal length in pixels. `offset`: the distance (px) of the ball's image from the center.
    """
    fig, axis = figure(6.6, 3.0)
    axis.set(xlim=(-2.2, 3.6), ylim=(-1.25, 1.3), aspect="equal")
    axis.set_axis_off()
    slope, plane = 0.42, -1.3
    axis.plot([plane - 0.2, 3.3], [0, 0], color=GREY, lw=1.2, ls="--")
    axis.text(3.35, 0.12, "straight ahead", color=TEXT, fontsize=9, ha="right")
    axis.plot([plane, plane], [-1.0, 1.0], color=GREY, lw=3)
    axis.text(plane, 1.14, "image plane", color=TEXT, fontsize=9, ha="center")
    for side in (-1, 1):
        axis.plot([0, 0], [0.07 * side, 1.0 * side], color=GREY, lw=3)
    axis.text(0, 1.14, "hole", color=TEXT, fontsize=9, ha="center")
    axis.plot([plane, 2.3], [-slope * plane, -slope * 2.3], color=BLUE, lw=1.8)
    axis.add_patch(Circle((2.3, -slope * 2.3), 0.16, color="#eb7819"))
    axis.text(2.58, -slope * 2.3, "ball", color=TEXT, fontsize=10, va="center")
    axis.plot([plane, plane], [0, -slope * plane], color=AMBER, lw=4)
    axis.text(
        plane - 0.12,
        -slope * plane / 2,
        f"x = {offset:.0f} px",
        color=TEXT,
        fontsize=10,
        ha="right",
        va="center",
    )
    axis.annotate("", (plane, -0.2), (0, -0.2), arrowprops={"arrowstyle": "<->", "color": GREY})
    axis.text(plane / 2, -0.5, f"focal length\n{focal:.0f} px", color=TEXT, fontsize=10, **_LOOKS)
    turned = math.degrees(math.atan(slope))
    axis.add_patch(Wedge((0, 0), 0.9, -turned, 0, width=0.02, color=AMBER))
    axis.text(0.98, -0.2, "angle", color=TEXT, fontsize=10, va="center")
    axis.set_title(f"Offset and focal length give the angle: tan(angle) = x / {focal:.0f}", fontsize=11)
    return fig
