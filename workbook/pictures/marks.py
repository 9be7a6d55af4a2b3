"""Find gaps between marks and draw a timeline small enough for a line of text. This module doesn't need matplotlib."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from workbook.pictures.palette import BLUE, GREY, RED, rgba
from workbook.pictures.png import encode

TINY_WIDTH, TINY_HEIGHT = 240, 18
"""The size of a tiny timeline in pixels. It's as tall as a line of text."""
TINY_SCALE = 2
"""Dots per pixel, for high-resolution screens."""
GAP = 1.5
"""The time between two messages is a gap if it's longer than this many periods."""


def gaps(
    times: Sequence[float], period: float, start: float | None = None, end: float | None = None
) -> list[tuple[float, float]]:
    """Return the spans (start and end in s) without a mark that are longer than 1.5 periods.

    They include spans between a bound (`start` or `end`) and the nearest mark.
    """
    edges = [*([] if start is None else [start]), *sorted(times), *([] if end is None else [end])]
    return [(a, b) for a, b in pairwise(edges) if b - a > GAP * period + 1e-9]


def tiny(
    times: Sequence[float],
    *,
    end: float,
    start: float = 0.0,
    period: float | None = None,
) -> bytes:
    """Draw a timeline that is only as tall as a line of text, for a card, and return PNG bytes.

    Marks are blue, and gaps are red.
    """
    pixels = np.zeros((TINY_HEIGHT * TINY_SCALE, TINY_WIDTH * TINY_SCALE, 4), np.uint8)
    height, width = pixels.shape[:2]
    span = end - start if end > start else 1.0

    def column(t: float) -> int:
        return round((t - start) / span * (width - 6)) + 3

    def paint(x0: int, x1: int, y0: int, y1: int, color: str, alpha: float) -> None:
        pixels[y0:y1, max(0, x0) : min(width, x1)] = [round(part * 255) for part in rgba(color, alpha)]

    middle = height // 2
    for a, b in gaps(times, period, start, end) if period else ():
        paint(column(a), column(b), 4, height - 4, RED, 0.35)
        paint(column(a), column(b), middle - 2, middle + 2, RED, 1.0)
    paint(0, width, middle - 1, middle + 1, GREY, 0.7)
    for t in times:
        if start <= t <= end:
            paint(column(t) - 2, column(t) + 3, 3, height - 3, BLUE, 1.0)
    return encode(pixels, dots_per_pixel=TINY_SCALE)
