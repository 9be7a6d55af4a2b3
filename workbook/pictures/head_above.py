"""Draw the robot's head from above, with its line of sight and the ball."""

import math

from workbook.pictures.canvas import Canvas, Font, Paint, Point
from workbook.pictures.palette import BLUE, GREY

WIDTH, HEIGHT = 260, 240
_CENTER: Point = (130.0, 206.0)
_PIXELS_PER_M = 190.0
_BALL = "#eb7819"
_SHELL, _DARK = "#eef2f7", "#4c5a69"


def draw(neck: float, ball: tuple[float, float] | None, scale: float = 1.5) -> bytes:
    """Draw the head turned to the left by `neck` (rad) and return PNG bytes.

    `ball`: the ball's distances (m) in front of the robot and to its left, or None if they're unknown.
    """
    canvas = Canvas(WIDTH, HEIGHT, scale)
    end = _ahead(neck, 172)
    canvas.line([_CENTER, _ahead(0.0, 172)], Paint(stroke=GREY, width=1.5, dash=(4, 5)))
    canvas.capsule((_CENTER[0] - 52, _CENTER[1]), (_CENTER[0] + 52, _CENTER[1]), 13, 13, Paint(fill=_DARK))
    canvas.line([_CENTER, end], Paint(stroke=BLUE, width=3))
    tips = [_ahead(neck + side * 0.05, 158) for side in (-1, 1)]
    canvas.polygon([end, *tips], Paint(fill=BLUE))
    for side in (-1, 1):
        ear = _ahead(neck + side * math.pi / 2, 27)
        canvas.disc(ear, 7, Paint(fill=BLUE, stroke=GREY, width=1.6))
    canvas.disc(_CENTER, 26, Paint(fill=_SHELL, stroke=GREY, width=2.2))
    for side in (-1, 1):
        canvas.disc(_ahead(neck + side * 0.45, 18), 4, Paint(fill=_DARK))
    if ball is not None:
        canvas.disc(_place(ball), 10, Paint(fill=_BALL, stroke=GREY, width=1.6))
    canvas.text((8, 20), "from above", Font(size=15))
    return canvas.png()


def _ahead(angle: float, pixels: float) -> Point:
    return (_CENTER[0] - pixels * math.sin(angle), _CENTER[1] - pixels * math.cos(angle))


def _place(ball: tuple[float, float]) -> Point:
    return (_CENTER[0] - _PIXELS_PER_M * ball[1], _CENTER[1] - _PIXELS_PER_M * ball[0])
