"""Draw timelines: the times at which messages arrived or were expected, and the gaps."""

import math
from bisect import bisect_right
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from statistics import fmean, median, pstdev
from typing import Any

import numpy as np

from workbook.pictures.canvas import Canvas, Font, Paint, shorten, text_width
from workbook.pictures.marks import gaps
from workbook.pictures.palette import AMBER, BLUE, RED, TEXT
from workbook.recording.recording import Recording

WIDTH = 680
AS_DUE = 0.1
"""If a rate is off by at most this fraction, the description states the required rate instead."""

_ROW, _TOP, _LEFT, _RIGHT = 40.0, 12.0, 16.0, 16.0
_TITLE = 20.0


@dataclass(frozen=True)
class Row:
    """One line of a timeline: a label and the times (s) of its marks.

    `period` (s) is the required period, which determines the expected ticks and which gaps count. `start` and `end`
    bound the time in which marks could be seen; outside of it, nothing counts as missing. `note` is shown at the right
    of the line. `color` is from the palette. The default is blue, because most marks are data.
    """

    label: str
    times: Sequence[float]
    period: float | None = None
    start: float | None = None
    end: float | None = None
    note: str | None = None
    color: str = BLUE


def timeline(
    recording: Recording,
    *,
    periods: Mapping[str, float] | None = None,
    topics: Sequence[str] | None = None,
    width: float = WIDTH,
    ink: str = TEXT,
) -> bytes:
    """Draw a recording and return PNG bytes: a row per topic, with a mark per arrival, over simulated time (s).

    `periods` (s, by topic) adds the expected ticks and shades the gaps. `topics` selects and orders the rows; by
    default, these are all topics in `periods` or with a publisher. If the program ended by itself, its end is marked.
    `ink`: the color of the labels.
    """
    asked = dict(periods or {})
    names = list(topics) if topics is not None else _topics(recording, asked)
    rows = []
    for name in names:
        topic = recording.topic(name)
        window = topic.window or (0.0, recording.watched_s)
        times = [arrival.t for arrival in topic.arrivals]
        note = _rate_words(times, step_s=recording.step_s)
        rows.append(Row(name, times, asked.get(name), window[0], window[1], note))
    return draw(rows, end=recording.watched_s, program_end=process_end(recording), width=width, ink=ink)


def strip(
    times_by_label: Mapping[str, Sequence[float]],
    *,
    periods: Mapping[str, float] | None = None,
    start: float = 0.0,
    end: float | None = None,
    noun: str = "messages",
    title: str = "",
    width: float = WIDTH,
) -> bytes:
    """Draw a row of marks for each label, at the given times (s), and return PNG bytes.

    The marks can be the ticks of two timers, for example. `periods` (s, by label) adds the expected ticks, counted from
    the first mark, and shades gaps between marks. `noun` names the marks in the plural, for the counts at the right.
    `title` is shown above.
    """
    asked = dict(periods or {})
    rows = [
        Row(label, times, asked.get(label), note=_rate_words(times, noun))
        for label, times in times_by_label.items()
    ]
    return draw(rows, start=start, end=end, title=title, width=width)


def draw(
    rows: Sequence[Row],
    *,
    start: float = 0.0,
    end: float | None = None,
    program_end: float | None = None,
    now: float | None = None,
    title: str = "",
    width: float = WIDTH,
    ink: str = TEXT,
) -> bytes:
    """Draw rows over one time axis from `start` to `end` (s), and return PNG bytes.

    Without `end`, the axis ends at the last mark. `program_end` (s) marks the end of the program. `now` (s) draws a
    vertical line at that time, for a film's frame. `title` is shown above, and states the finding. `ink`: the color of
    the labels.
    """
    last = max((t for row in rows for t in row.times), default=start)
    stop = end if end is not None else last
    if not math.isfinite(stop) or stop <= start:
        stop = start + 1.0
    top = _TOP + (_TITLE if title else 0.0)
    bottom = top + _ROW * max(1, len(rows))
    canvas = Canvas(width, bottom + 40, ink=ink)
    canvas.text((_LEFT, 17), shorten(title, width - 2 * _LEFT, 13.5, bold=True), Font(size=13.5, bold=True))
    labels = max((text_width(row.label, 12.5) for row in rows), default=0.0)
    left = _LEFT + min(labels, 220.0) + 14
    notes = [row.note if row.note is not None else _rate_words(row.times) for row in rows]
    right = width - _RIGHT - max((text_width(note, 11.5) for note in notes), default=0.0) - 14
    axis = _Axis(start, stop, left, right)
    if not rows:
        canvas.text((left, bottom - 12), "nothing was published", Font(size=12.5))
    _axis(canvas, axis, bottom)
    for index, (row, note) in enumerate(zip(rows, notes, strict=True)):
        y = top + _ROW * (index + 0.5)
        canvas.text((left - 14, y + 4.5), shorten(row.label, 220, 12.5), Font(size=12.5), align="right")
        canvas.text((right + 14, y + 4.5), note, Font(size=11.5))
        _row(canvas, axis, row, y)
    if now is not None:
        canvas.line([(axis.clip(now), 4), (axis.clip(now), bottom)], Paint(width=1.6))
    if program_end is not None and start <= program_end <= stop:
        _mark_end(canvas, axis.x(program_end), bottom)
    return canvas.png()


def _mark_end(canvas: Canvas, x: float, bottom: float) -> None:
    canvas.line([(x, 4), (x, bottom)], Paint(stroke=RED, width=2))
    room = canvas.width - x - 8
    words = shorten("✗ the program ended here", max(room, x - 8), 11.5, bold=True)
    fits = text_width(words, 11.5, bold=True) <= room
    canvas.text(
        (x + 6 if fits else x - 6, bottom + 32),
        words,
        Font(size=11.5, bold=True),
        align="left" if fits else "right",
    )


def histogram(
    values: Sequence[float],
    *,
    target: float | None = None,
    unit: str = "ms",
    label: str = "time between two messages",
    title: str = "",
    bins: int = 24,
    width: float = 520,
) -> bytes:
    """Draw a histogram that shows how often each value occurs, and return PNG bytes. `target` is marked.

    Mean, spread, and `title` are shown above. Values that aren't finite are ignored. Raises ValueError if no value is
    left.
    """
    kept = [value for value in values if math.isfinite(value)]
    if not kept:
        raise ValueError("a histogram needs at least one finite value")
    everything = [*kept, *([] if target is None else [target])]
    low, high = min(everything), max(everything)
    margin = (high - low) * 0.06 or max(abs(high) * 0.01, 1e-6)
    counts, _ = np.histogram(kept, bins=bins, range=(low - margin, high + margin))
    top = _TITLE if title else 0.0
    canvas = Canvas(width, 228 + top)
    axis = _Axis(low - margin, high + margin, 24.0, width - 24.0)
    base, tall = 172.0 + top, 116.0
    step = (axis.right - axis.left) / bins
    for index, count in enumerate(counts):
        height = tall * float(count) / float(max(counts))
        canvas.box(
            (axis.left + index * step + 1, base - height), (step - 2, height), Paint(fill=BLUE), radius=2
        )
    _value_axis(canvas, axis, base, f"{label} ({unit})")
    if target is not None:
        _target(canvas, axis, base, target, unit)
    words = f"{len(kept)} values · mean {fmean(kept):.4g} {unit} · spread {pstdev(kept):.2g} {unit}"
    canvas.text((axis.left, 17), shorten(title, width - 48, 13.5, bold=True), Font(size=13.5, bold=True))
    canvas.text((axis.left, 20 + top), words, Font(size=12))
    return canvas.png()


def describe(recording: Recording, periods: Mapping[str, float] | None = None) -> str:
    """Describe the timeline in words, for use as its alternative text.

    The text states the topics, the measured and required rates, and whether there are gaps.

    If a rate is close to the required one, the text states only the required rate. So it's the same in every run of a
    program that keeps its rates.
    """
    asked = dict(periods or {})
    parts = []
    for name in _topics(recording, asked):
        topic = recording.topic(name)
        times = [arrival.t for arrival in topic.arrivals]
        if not times:
            parts.append(f"{name} silent")
        elif name in asked:
            window = topic.window or (0.0, recording.watched_s)
            found = gaps(times, asked[name], *window)
            pace = _pace_words(times, asked[name], recording.step_s)
            parts.append(f"{name} {pace}, {'with gaps' if found else 'without a gap'}")
        else:
            parts.append(name)
    ended = "; the program ended early" if process_end(recording) is not None else ""
    return f"timeline of messages: {'; '.join(parts) or 'nothing was published'}{ended}"


def _at_least(hz: float, step_s: float | None) -> str:
    """Return "≥ " if a rate is close to the rate of simulated time's steps, or "" otherwise.

    In that case, the true rate may be higher. `step_s`: the length of a step in seconds.
    """
    return "≥ " if step_s is not None and hz * step_s > 0.5 + 1e-6 else ""


def _pace_words(times: Sequence[float], period: float, step_s: float | None) -> str:
    due = f"{1 / period:.3g} Hz"
    span = max(times) - min(times)
    if span <= 0:
        return f"{'once' if len(times) == 1 else f'{len(times)} times at the same moment'} ({due} due)"
    seen = (len(times) - 1) / span
    if abs(seen * period - 1) <= AS_DUE:
        return f"at {due} as due"
    return f"at {_at_least(seen, step_s)}{seen:.2g} Hz ({due} due)"


def process_end(recording: Recording) -> float | None:
    """Return the simulated time (s) at which the program exited by itself, or None if it didn't."""
    process = recording.process
    if process.ended_by != "itself" or process.ended_at is None:
        return None
    pairs: list[tuple[float, float]] = sorted(
        (arrival.wall, arrival.t) for topic in recording.topics.values() for arrival in topic.arrivals
    )
    speed_at = {phase.start: phase.speed for phase in recording.stretches}
    at = bisect_right([wall for wall, _ in pairs], process.ended_at) - 1
    if at >= 0:
        wall, t = pairs[at]
        begun = [start for start in speed_at if start <= t]
        speed = speed_at[max(begun)] if begun else 1.0
        t += (process.ended_at - wall) * speed
    else:
        t = process.ended_at
    return max(0.0, min(t, recording.watched_s))


@dataclass(frozen=True)
class _Axis:
    start: float
    end: float
    left: float
    right: float

    def x(self, t: float) -> float:
        return self.left + (t - self.start) / (self.end - self.start) * (self.right - self.left)

    def clip(self, t: float) -> float:
        return self.x(min(max(t, self.start), self.end))

    def bounds(self, row: Row) -> tuple[float, float]:
        """Return the time span (s) in which a row's marks could be seen."""
        return (
            self.start if row.start is None else row.start,
            self.end if row.end is None else row.end,
        )


def _value_axis(canvas: Canvas, axis: _Axis, base: float, label: str) -> None:
    canvas.line([(axis.left, base), (axis.right, base)], Paint(width=1.4))
    for value in _ticks(axis.start, axis.end, 6):
        canvas.line([(axis.x(value), base), (axis.x(value), base + 4)], Paint(width=1.4))
        canvas.text((axis.x(value), base + 18), _number(value), Font(size=11.5), align="center")
    canvas.text(((axis.left + axis.right) / 2, base + 40), label, Font(size=12), align="center")


def _target(canvas: Canvas, axis: _Axis, base: float, target: float, unit: str) -> None:
    x = axis.x(target)
    canvas.line([(x, base - 128), (x, base)], Paint(stroke=AMBER, width=2, dash=(5, 4)))
    on_the_left = x < canvas.width / 2
    canvas.text(
        (x + (6 if on_the_left else -6), base - 126),
        f"asked: {_number(target)} {unit}",
        Font(size=11.5, bold=True),
        align="left" if on_the_left else "right",
    )


def _row(canvas: Canvas, axis: _Axis, row: Row, y: float) -> None:
    begin, finish = axis.bounds(row)
    drawn = axis.clip(begin)  # the position up to which the line has been drawn
    if row.period:
        _expected(canvas, axis, row, y)
        for a, b in gaps(row.times, row.period, row.start, row.end):
            x0, x1 = axis.clip(a), axis.clip(b)
            place, size = (x0 + 3, y - 12), (max(2.0, x1 - x0 - 6), 24.0)
            words, middle = f"✗ {b - a:.3g} s", (x0 + x1) / 2
            wide = text_width(words, 11, bold=True)
            told = wide < x1 - x0 - 10
            # No text color has enough contrast on a tinted background in both themes.
            canvas.box(
                place, size, Paint(stroke=RED, width=1.8) if told else Paint(fill=RED, alpha=0.24), radius=4
            )
            if told:  # the line stops at the words, so that it doesn't cross them out
                canvas.text((middle, y + 4), words, Font(size=11, bold=True), align="center")
                _base_line(canvas, drawn, max(drawn, middle - wide / 2 - 5), y)
                drawn = middle + wide / 2 + 5
    _base_line(canvas, drawn, axis.clip(finish), y)
    xs = sorted({round(axis.x(t) * 2) / 2 for t in row.times if axis.start <= t <= axis.end})
    close = len(xs) > 1 and median(b - a for a, b in pairwise(xs)) < 5
    for x in xs:
        canvas.line(
            [(x, y - 9), (x, y + 9)],
            Paint(stroke=row.color, width=1.2 if close else 3.4, alpha=0.8 if close else 1.0),
        )


def _base_line(canvas: Canvas, left: float, right: float, y: float) -> None:
    if right > left:
        canvas.line([(left, y), (right, y)], Paint(width=1.4, alpha=0.55))


def _expected(canvas: Canvas, axis: _Axis, row: Row, y: float) -> None:
    begin, finish = axis.bounds(row)
    period = row.period or 1.0
    anchor = min(row.times, default=begin + period)
    count = (finish - begin) / period
    if axis.x(axis.start + period) - axis.left < 4 or count > 2000:
        return  # too close together to see
    first = math.ceil((max(begin, axis.start) - anchor) / period - 1e-9)
    last = math.floor((min(finish, axis.end) - anchor) / period + 1e-9)
    for index in range(first, last + 1):
        x = axis.x(anchor + index * period)
        canvas.line([(x, y - 15), (x, y - 11)], Paint(width=1.6, alpha=0.8))
        canvas.line([(x, y + 11), (x, y + 15)], Paint(width=1.6, alpha=0.8))


def _axis(canvas: Canvas, axis: _Axis, y: float) -> None:
    canvas.line([(axis.left, y), (axis.right, y)], Paint(width=1.4))
    for value in _ticks(axis.start, axis.end, max(3, int((axis.right - axis.left) / 60))):
        x = axis.x(value)
        canvas.line([(x, y), (x, y + 4)], Paint(width=1.4))
        canvas.text((x, y + 17), _number(value), Font(size=11), align="center")
    canvas.text((axis.right + 14, y + 17), "s", Font(size=11))


def _ticks(start: float, end: float, most: int) -> list[float]:
    span = end - start
    power = 10.0 ** math.floor(math.log10(span / most))
    step = next(part * power for part in (1, 2, 5, 10, 20) if span / (part * power) <= most)
    first, last = math.ceil(start / step - 1e-9), math.floor(end / step + 1e-9)
    return [round(index * step, 12) for index in range(first, last + 1)]


def _number(value: float) -> str:
    return f"{value:.6g}".replace("-", "−")


def _rate_words(times: Sequence[float], noun: str = "messages", step_s: float | None = None) -> str:
    if len(times) < 2:
        return f"1 {noun.removesuffix('s')}" if times else "✗ none"
    span = max(times) - min(times)
    hz = (len(times) - 1) / span if span > 0 else 0.0
    rate = f" · {_at_least(hz, step_s)}{hz:.3g} Hz" if hz else ""
    return f"{len(times)} {noun}{rate}"


def _topics(recording: Recording, asked: Mapping[str, Any]) -> list[str]:
    hidden = ("/rosout", "/parameter_events", "/clock")
    seen = [topic.name for topic in recording.with_publishers() if topic.name not in hidden]
    return [*asked, *(name for name in seen if name not in asked)]
