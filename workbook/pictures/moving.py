"""Play recordings back as moving figures, without a running program: marks on lines, and robots."""

import io
import math
from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from PIL import Image

from workbook.pictures import humanoid
from workbook.pictures.canvas import Canvas, Font, Paint
from workbook.pictures.film import moving_png
from workbook.pictures.joints import JOINT_NAMES, NEUTRAL
from workbook.pictures.palette import GREEN, RED
from workbook.pictures.stills import Still
from workbook.pictures.timeline import Row, draw

PER_SECOND = 8.0
"""Frames per second of real time."""
STEPS = 12
"""The number of poses in one wave of the hand. At each of its heartbeats, a robot moves to the next pose."""
_SCALE = 0.66
_PIXELS = round(humanoid.WIDTH * _SCALE)


@dataclass(frozen=True)
class Robot:
    """A robot in a film: its name, its heartbeats (s), and the text below it while it stands still.

    `period`: the planned time (s) between heartbeats. If a heartbeat is late by another period, the robot stands still.
    """

    name: str
    beats: Sequence[float]
    period: float
    trouble: str = "blocked"


def played_back(
    rows: Sequence[Row], description: str, *, end: float, pace: float = 1.0, title: str = ""
) -> Still:
    """Draw a timeline's rows as a film, in which time passes from 0 s to `end` (s).

    `pace`: recorded seconds per second of film. `description`: the alternative text. `title` is shown above.
    """
    frames = []
    counted = [row if row.note is not None else replace(row, note="") for row in rows]
    for now in moments(end, pace):
        seen = [_until(row, now) for row in counted]
        frames.append(draw(seen, end=end, now=now, title=title))
    return Still(moving_png(frames, per_second=PER_SECOND, dots_per_pixel=2.0), description)


def robots(those: Sequence[Robot], description: str, *, end: float, pace: float = 1.0) -> Still:
    """Draw a film of robots next to each other. Each moves a little at each heartbeat, and otherwise stands still.

    Time passes from 0 s to `end` (s). `pace`: recorded seconds per second of film. `description`: the alternative text.
    """
    poses: dict[tuple[int, bool], Image.Image] = {}
    frames = []
    for now in moments(end, pace):
        width = _PIXELS * len(those)
        sheet = Image.new("RGBA", (width, _PIXELS + 46))
        for place, one in enumerate(those):
            count = bisect_right(one.beats, now)
            late = is_late(one, now)
            key = (count % STEPS, late)
            if key not in poses:
                poses[key] = _posed(*key)
            sheet.paste(poses[key], (place * _PIXELS, 0))
        words = _words(those, now)
        sheet.paste(words, (0, _PIXELS - 6), words)
        file = io.BytesIO()
        sheet.save(file, "PNG")
        frames.append(file.getvalue())
    return Still(moving_png(frames, per_second=PER_SECOND, dots_per_pixel=1.0), description)


def moments(end: float, pace: float) -> list[float]:
    """Return the times (s) of a film's frames, from 0 to `end`."""
    count = max(2, round(end / pace * PER_SECOND))
    return [end * place / (count - 1) for place in range(count)]


def is_late(robot: Robot, now: float) -> bool:
    """Return whether the robot's next heartbeat is late by more than a period at the time `now` (s)."""
    count = bisect_right(robot.beats, now)
    last = robot.beats[count - 1] if count else 0.0
    return now - last > 2 * robot.period


def _until(row: Row, now: float) -> Row:
    start = row.start or 0.0
    end = min(row.end if row.end is not None else math.inf, now)
    return replace(row, times=[t for t in row.times if t <= now], end=max(start, end))


def _posed(step: int, late: bool) -> Image.Image:
    angles = list(NEUTRAL)
    angles[JOINT_NAMES.index("left_shoulder")] = 2.4
    angles[JOINT_NAMES.index("left_elbow")] = 0.5 + 0.45 * math.sin(2 * math.pi * step / STEPS)
    drawn = humanoid.draw(angles, lamp="error" if late else "operational", scale=_SCALE)
    return Image.open(io.BytesIO(drawn)).convert("RGBA").crop((0, 0, _PIXELS, _PIXELS))


def _words(those: Sequence[Robot], now: float) -> Image.Image:
    canvas = Canvas(_PIXELS * len(those), 52, 1.0)
    for place, one in enumerate(those):
        middle = _PIXELS * (place + 0.5)
        count, late = bisect_right(one.beats, now), is_late(one, now)
        canvas.text((middle, 16), one.name, Font(size=13, bold=True), align="center")
        words = f"✗ {one.trouble}" if late else "✓ moving"
        told = Font(size=12.5, bold=True, color=RED if late else GREEN)
        canvas.text((middle, 34), f"{count} beats · {words}", told, align="center")
    canvas.line([(0, 50), (canvas.width * now / _last(those), 50)], Paint(width=2))
    return Image.open(io.BytesIO(canvas.png())).convert("RGBA")


def _last(those: Sequence[Robot]) -> float:
    return max((beat for one in those for beat in one.beats), default=1.0)


def by_name(beats: Mapping[str, Sequence[float]], period: float, trouble: str = "blocked") -> list[Robot]:
    """Return a robot for each name in `beats`, which maps names to the times of heartbeats (s).

    `period` and `trouble` are the same for all (see `Robot`).
    """
    return [Robot(name, times, period, trouble) for name, times in beats.items()]
