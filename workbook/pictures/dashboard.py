"""Draw a small dashboard: the status as a lamp with its word, the battery as a gauge, and the arrival times."""

import math
from collections.abc import Mapping, Sequence

from workbook.pictures.canvas import Canvas, Font, Paint, shorten
from workbook.pictures.palette import AMBER, BLUE, GREEN, GREY, RED

WIDTH, ROW = 560, 30
DESCRIPTION = "robot dashboard with status lamp, battery gauge and message timeline"
STATUS_TOPIC, BATTERY_TOPIC = "/robot/status", "/robot/battery"

_LABEL, _RIGHT = 150.0, 58.0


def draw(
    status: str | None,
    battery: float | None,
    arrivals: Mapping[str, Sequence[float]],
    *,
    now: float,
    window: float = 10.0,
) -> bytes:
    """Return the dashboard as PNG bytes.

    `status` is the last word received and `battery` the last percentage; each is None before its first message.
    `arrivals` maps each topic to its arrival times, in seconds on the same clock as `now`. The arrivals in the last
    `window` seconds are drawn. Any word and any number can be shown, and invalid ones are marked. Raises ValueError
    unless `window` is positive.
    """
    if not window > 0:
        raise ValueError(f"the window must be longer than 0 s, not {window}")
    top = 104
    canvas = Canvas(WIDTH, top + ROW * max(1, len(arrivals)) + 26)
    _lamp(canvas, status)
    _battery(canvas, battery)
    _rows(canvas, arrivals, now, window, top)
    return canvas.png()


def _lamp(canvas: Canvas, status: str | None) -> None:
    color, sign = {
        "operational": (GREEN, "✓"),
        "error": (RED, "!"),
        None: (GREY, "…"),
    }.get(status, (AMBER, "?"))
    center = (44.0, 50.0)
    canvas.disc(center, 34, Paint(fill=color, alpha=0.18 if status else 0.0))
    canvas.disc(center, 26, Paint(fill=color, stroke=GREY, width=2.4))
    canvas.disc((center[0] - 8, center[1] - 11), 7, Paint(fill="#ffffff", alpha=0.25), flat=0.7)
    canvas.text((center[0], center[1] + 8), sign, Font(size=23, bold=True, color="#ffffff"), align="center")
    canvas.text((92, 38), "status", Font(size=12))
    if status is None:
        canvas.text((92, 62), "no message yet", Font(size=16))
    else:
        word = status if status.strip() else "(empty text)"
        canvas.text((92, 62), shorten(word, 164, 19, bold=True), Font(size=19, bold=True, color=color))


def _battery(canvas: Canvas, battery: float | None) -> None:
    left, y, wide, high = 280.0, 26.0, 124.0, 46.0
    canvas.box((left + wide + 2, y + 13), (8, high - 26), Paint(fill=GREY), radius=3)
    text = left + wide + 24
    canvas.text((text, 38), "battery", Font(size=12))
    if battery is None:
        words, color, level = "no message yet", GREY, 0.0
    elif not math.isfinite(battery):
        words, color, level = "✗ not a number", RED, 0.0
    elif not 0 <= battery <= 100:
        words, color, level = f"✗ {battery:.4g} %", RED, max(0.0, min(1.0, battery / 100))
    else:
        level = battery / 100
        color = GREEN if battery > 50 else AMBER if battery > 20 else RED
        words = f"{battery:.1f} %"
    room = wide - 10
    canvas.box((left + 5, y + 5), (room * level, high - 10), Paint(fill=color), radius=5)
    canvas.box((left, y), (wide, high), Paint(stroke=GREY, width=2.4), radius=9)
    for quarter in (1, 2, 3):
        x = left + 5 + room * quarter / 4
        canvas.line([(x, y + 6), (x, y + high - 6)], Paint(width=1.2, alpha=0.45))
    canvas.text(
        (text, 62), words, Font(size=19 if len(words) < 8 else 13, bold=battery is not None, color=color)
    )
    if battery is not None and 0 <= battery <= 20:
        canvas.text(
            (left + wide / 2, y + high + 16),
            "low" if battery > 0 else "empty",
            Font(size=12, bold=True, color=RED),
            align="center",
        )


def _rows(
    canvas: Canvas, arrivals: Mapping[str, Sequence[float]], now: float, window: float, top: float
) -> None:
    left, right = _LABEL, WIDTH - _RIGHT
    bottom = top + ROW * max(1, len(arrivals))

    def place(t: float) -> float:
        return right - (now - t) / window * (right - left)

    canvas.text((right, bottom + 16), "now", Font(size=11), align="center")
    canvas.text((left, bottom + 16), f"−{window:g} s", Font(size=11), align="center")
    step = _second_step(window)
    for index in range(math.floor(window / step) + 1):
        x = place(now - index * step)
        canvas.line([(x, bottom - 3), (x, bottom + 2)], Paint(width=1.2, alpha=0.8))
    canvas.line([(left, bottom), (right, bottom)], Paint(width=1.4, alpha=0.8))
    for index, (topic, times) in enumerate(arrivals.items()):
        y = top + ROW * index + ROW / 2
        canvas.text((left - 12, y + 4), shorten(topic, _LABEL - 18, 12), Font(size=12), align="right")
        canvas.line([(left, y), (right, y)], Paint(width=1.2, alpha=0.35))
        seen = [t for t in times if now - window <= t <= now]
        drawn = {
            round(place(t) / 2): t for t in seen
        }  # for a fast topic, one mark per 2 pixels is all that is visible
        for t in drawn.values():
            age = (now - t) / window
            canvas.disc((place(t), y), 5.0, Paint(fill=BLUE, alpha=1.0 - 0.55 * age))
            if now - t < 0.35:  # a ring that expands around a message that has just arrived
                grown = (now - t) / 0.35
                canvas.disc((place(t), y), 6 + 7 * grown, Paint(stroke=BLUE, width=2, alpha=1 - grown))
        canvas.text((right + 12, y + 4), f"{len(seen)} ×", Font(size=12))


def _second_step(window: float) -> float:
    for step in (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 60.0):
        if window / step <= 12:
            return step
    return window / 10
