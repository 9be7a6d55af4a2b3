"""Draw an egg between two closing fingers, to show how a delayed stop breaks it."""

from collections.abc import Mapping

from workbook.pictures.canvas import Canvas, Font, Paint, Point
from workbook.pictures.film import moving_png
from workbook.pictures.palette import GREEN, GREY, RED
from workbook.pictures.stills import Still

SPEED_MM_S = 100.0
"""The speed at which the gap between the two fingers closes."""
BREAKS_AT_MM = 2.0
"""The shell breaks if the fingers squeeze it by more than this."""
PER_SECOND = 8.0
_WIDTH, _HEIGHT, _MIDDLE = 330.0, 240.0, 112.0
_RADIUS = 46.0
_PIXELS_PER_MM = 7.0
_BEFORE_MS, _AFTER_MS, _STEP_MS = 8, 14, 2


def squeezed_mm(late_ms: float, after_touch_ms: float) -> float:
    """Return the distance (mm) by which the fingers have squeezed the egg at a time (ms) after the touch.

    The fingers stop `late_ms` after the touch.
    """
    return SPEED_MM_S * max(0.0, min(late_ms, after_touch_ms)) / 1000


def squeeze(late_ms: Mapping[str, float], description: str) -> Still:
    """Show, in slow motion, two fingers squeezing each of several eggs that are drawn side by side.

    `late_ms` maps each egg's title to the delay (ms) after which the fingers stop. `description` is the alternative
    text.
    """
    last = round(max(late_ms.values())) + _AFTER_MS
    frames = []
    for now in range(-_BEFORE_MS, last, _STEP_MS):
        canvas = Canvas(_WIDTH * len(late_ms), _HEIGHT, 1.5)
        for place, (name, late) in enumerate(late_ms.items()):
            _egg_and_fingers(canvas, _WIDTH * (place + 0.5), late, now)
            canvas.text((_WIDTH * (place + 0.5), 20), name, Font(size=14, bold=True), align="center")
            _verdict(canvas, _WIDTH * (place + 0.5), late, now)
        when = f"{now} ms after the touch" if now >= 0 else "before the touch"
        canvas.text((canvas.width / 2, _HEIGHT - 6), when, Font(size=12), align="center")
        frames.append(canvas.png())
    return Still(moving_png(frames, per_second=PER_SECOND, dots_per_pixel=1.5), description)


def _egg_and_fingers(canvas: Canvas, x: float, late: float, now: float) -> None:
    inward = squeezed_mm(late, now) * _PIXELS_PER_MM / 2
    gap = max(0.0, -now) * SPEED_MM_S / 1000 * _PIXELS_PER_MM / 2
    half = _RADIUS * 0.8 - inward + gap
    if squeezed_mm(late, now) > BREAKS_AT_MM:
        _broken(canvas, (x, _MIDDLE), half)
    else:
        shell = Paint(fill="#f4e3cf", stroke=GREY, width=2)
        canvas.disc((x, _MIDDLE), half - gap, shell, flat=_RADIUS / (half - gap))
    for side in (-1, 1):
        outer = x + side * (half + 26)
        inner = x + side * half
        finger = Paint(fill="#cdd7e3", stroke=GREY, width=2)
        canvas.box((min(inner, outer), _MIDDLE - 44), (26, 88), finger, radius=9)


def _broken(canvas: Canvas, at: Point, half: float) -> None:
    x, y = at
    canvas.disc((x, y + 52), 58, Paint(fill="#f6c445", alpha=0.9), flat=0.2)
    canvas.disc((x, y + 6), half, Paint(fill="#f4e3cf", stroke=GREY, width=2), flat=_RADIUS / half * 0.8)
    crack = [(x - half * 0.8, y - 2), (x - 12, y + 12), (x, y - 8), (x + 12, y + 14), (x + half * 0.8, y - 4)]
    canvas.line(crack, Paint(stroke=RED, width=3))


def _verdict(canvas: Canvas, x: float, late: float, now: float) -> None:
    if now < 0:
        return
    squeezed = squeezed_mm(late, now)
    if squeezed > BREAKS_AT_MM:
        words, color = f"✗ crushed: {squeezed:.1f} mm", RED
    elif now >= late:
        words, color = f"✓ stopped after {late:.1f} ms: {squeezed:.1f} mm", GREEN
    else:
        words, color = "still closing", GREY
    canvas.text((x, _HEIGHT - 32), words, Font(size=13, bold=True, color=color), align="center")
