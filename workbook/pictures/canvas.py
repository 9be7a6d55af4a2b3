"""Draw on a small vector canvas: smooth shapes and text on a transparent background, fast enough for 30 frames/s.

Coordinates are page pixels, x to the right and y down. The image has `scale` dots per pixel, so it stays sharp on a
high-resolution screen. It uses matplotlib's rasterizer without a figure, axes, or global state.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Literal

import numpy as np
from matplotlib.backends.backend_agg import RendererAgg
from matplotlib.font_manager import FontProperties
from matplotlib.path import Path
from matplotlib.textpath import text_to_path
from matplotlib.transforms import Affine2D

from workbook.pictures.palette import GREY, TEXT, rgba
from workbook.pictures.png import encode

Point = tuple[float, float]
Align = Literal["left", "center", "right"]


@dataclass(frozen=True)
class Paint:
    """A shape's style: `fill` and `stroke` are colors; `width` (px) and `dash` (px on, px off) apply to the line.

    Without `fill`, only the line is drawn; without `stroke`, only the face. `alpha`: 0 (invisible) to 1 (opaque).
    """

    fill: str | None = None
    stroke: str | None = None
    width: float = 2.0
    alpha: float = 1.0
    dash: Sequence[float] | None = None


@dataclass(frozen=True)
class Font:
    """How text is drawn. `size` is in pixels. Without `color`, it has the canvas's color of text."""

    size: float = 12.0
    color: str | None = None
    bold: bool = False


GREY_LINE = Paint(stroke=GREY)
PLAIN_TEXT = Font()


class Canvas:
    """A transparent image, `width` by `height` pixels. `ink`: the color of its text."""

    def __init__(self, width: float, height: float, scale: float = 2.0, ink: str = TEXT) -> None:
        self.width, self.height, self.scale, self.ink = width, height, scale, ink
        self._renderer = RendererAgg(round(width * scale), round(height * scale), 72)
        self._pen = self._renderer.new_gc()
        self._base = Affine2D.from_values(scale, 0, 0, -scale, 0, round(height * scale))

    def png(self) -> bytes:
        """Return the image as PNG bytes."""
        return encode(np.asarray(self._renderer.buffer_rgba()), dots_per_pixel=self.scale)

    def path(self, path: Path, paint: Paint, *, at: Affine2D | None = None) -> None:
        """Draw any path, transformed by `at`."""
        pen = self._pen
        pen.set_linewidth(paint.width * self.scale if paint.stroke else 0.0)
        pen.set_foreground(rgba(paint.stroke or GREY, paint.alpha), isRGBA=True)
        pen.set_alpha(paint.alpha)
        pen.set_capstyle("round")
        pen.set_joinstyle("round")
        pen.set_dashes(0, [part * self.scale for part in paint.dash] if paint.dash else None)
        pen.set_antialiased(True)
        place = self._base if at is None else at + self._base
        self._renderer.draw_path(pen, path, place, rgba(paint.fill, paint.alpha) if paint.fill else None)

    def polygon(self, points: Iterable[Point], paint: Paint) -> None:
        """Draw a closed polygon."""
        corners = list(points)
        self.path(Path([*corners, corners[0]], closed=True), paint)

    def line(self, points: Iterable[Point], paint: Paint = GREY_LINE) -> None:
        """Draw an open line through the points, with round ends. It's gray if the paint has no stroke."""
        self.path(Path(list(points)), _stroked(paint))

    def curve(self, start: Point, pull: Point, push: Point, end: Point, paint: Paint = GREY_LINE) -> None:
        """Draw a Bézier curve from `start` to `end`. It's gray if the paint has no stroke.

        `pull` and `push` are the control points.
        """
        codes = [Path.MOVETO, Path.CURVE4, Path.CURVE4, Path.CURVE4]
        self.path(Path([start, pull, push, end], codes), _stroked(paint))

    def disc(self, center: Point, radius: float, paint: Paint, *, flat: float = 1.0) -> None:
        """Draw a disc of this radius, or an ellipse whose height is `flat` times its width."""
        place = Affine2D.from_values(radius, 0, 0, radius * flat, *center)
        self.path(_CIRCLE, paint, at=place)

    def box(
        self, corner: Point, size: Point, paint: Paint, *, radius: float = 0.0, at: Affine2D | None = None
    ) -> None:
        """Draw a box with rounded corners, given its upper left corner and its width and height."""
        width, height = size
        if width <= 0 or height <= 0:
            return
        self.path(rounded(*corner, width, height, min(radius, width / 2, height / 2)), paint, at=at)

    def capsule(self, start: Point, end: Point, start_radius: float, end_radius: float, paint: Paint) -> None:
        """Draw a limb: two round ends and the straight sides between them."""
        self.path(capsule(start, end, start_radius, end_radius), paint)

    def text(self, at: Point, words: str, font: Font = PLAIN_TEXT, *, align: Align = "left") -> None:
        """Draw one line of text. `at` lies on the baseline."""
        if not words:
            return
        outline, length = _outline(words, font.size, font.bold)
        shift = {"left": 0.0, "center": -length / 2, "right": -length}[align]
        place = Affine2D().translate(shift, 0).scale(1, -1).translate(*at)
        self.path(outline, Paint(fill=font.color or self.ink), at=place)


def _stroked(paint: Paint) -> Paint:
    return paint if paint.stroke else replace(paint, stroke=GREY)


def text_width(words: str, size: float = 12.0, *, bold: bool = False) -> float:
    """Return the width of a line of text in pixels."""
    return _outline(words, size, bold)[1] if words else 0.0


def shorten(words: str, room: float, size: float = 12.0, *, bold: bool = False) -> str:
    """Return the text, cut off with an ellipsis if it doesn't fit into `room` pixels."""
    if text_width(words, size, bold=bold) <= room:
        return words
    while words and text_width(words + "…", size, bold=bold) > room:
        words = words[:-1]
    return words + "…"


def capsule(start: Point, end: Point, start_radius: float, end_radius: float) -> Path:
    """Return the outline of two discs and the area between them."""
    dx, dy = end[0] - start[0], end[1] - start[1]
    length = math.hypot(dx, dy)
    if length <= abs(start_radius - end_radius):
        center, radius = (start, start_radius) if start_radius >= end_radius else (end, end_radius)
        return Path(np.asarray(_CIRCLE.vertices) * radius + np.asarray(center), _CIRCLE.codes)
    along = math.atan2(dy, dx)
    lean = math.acos((start_radius - end_radius) / length)
    points = [
        *_arc(end, end_radius, along - lean, along + lean),
        *_arc(start, start_radius, along + lean, along + 2 * math.pi - lean),
    ]
    return Path([*points, points[0]], closed=True)


@lru_cache(maxsize=512)
def rounded(x: float, y: float, width: float, height: float, radius: float) -> Path:
    """Return the outline of a box with rounded corners."""
    if radius <= 0:
        corners = [(x, y), (x + width, y), (x + width, y + height), (x, y + height), (x, y)]
        return Path(corners, closed=True)
    quarter = math.pi / 2
    points = [
        *_arc((x + width - radius, y + radius), radius, -quarter, 0),
        *_arc((x + width - radius, y + height - radius), radius, 0, quarter),
        *_arc((x + radius, y + height - radius), radius, quarter, 2 * quarter),
        *_arc((x + radius, y + radius), radius, 2 * quarter, 3 * quarter),
    ]
    return Path([*points, points[0]], closed=True)


def _arc(center: Point, radius: float, start: float, end: float) -> list[Point]:
    steps = max(3, math.ceil(abs(end - start) / 0.2))
    turn = (end - start) / steps
    return [
        (
            center[0] + radius * math.cos(start + step * turn),
            center[1] + radius * math.sin(start + step * turn),
        )
        for step in range(steps + 1)
    ]


@lru_cache(maxsize=2048)
def _outline(words: str, size: float, bold: bool) -> tuple[Path, float]:
    font = FontProperties(family="DejaVu Sans", weight="bold" if bold else "normal", size=size)
    vertices, codes = text_to_path.get_text_path(font, words)
    zoom = size / text_to_path.FONT_SCALE
    length, _, _ = text_to_path.get_text_width_height_descent(words, font, ismath=False)
    return Path(np.asarray(vertices) * zoom, codes), float(length)


_CIRCLE = Path.unit_circle()
