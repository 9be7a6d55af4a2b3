"""Draw the path from DDS to the callbacks at one instant, in the same way in all lessons.

The parts are queues, wait set, executor, and callbacks.

Each source of callbacks has a row: a subscription, client, or service has a queue, and a timer has room for one tick.
Arrived items are blue, and lost ones red. A running callback is green, or amber if it has been busy for long.
"""

from dataclasses import dataclass

from workbook.pictures.canvas import Canvas, Font, Paint, Point, shorten, text_width
from workbook.pictures.palette import AMBER, BLUE, GREEN, GREY, RED
from workbook.recording.machine import Call, Item, MachineRecording, Source

WIDTH = 760.0
TOP, ROW, BOTTOM = 26.0, 64.0, 52.0
SCALE = 1.5
SLOTS = 10
"""The number of queue slots that are drawn. If the queue is deeper, the other items are only counted."""
LONG_S = 0.15
"""A callback that has been busy for longer than this is drawn in amber, with its time."""
JUST_S = 0.03
"""Items that arrived or were lost less than this long ago are marked as new."""
DDS, QUEUE_END, WAIT_SET, EXECUTOR, CALLBACK = (
    (6.0, 72.0),
    326.0,
    (358.0, 62.0),
    (448.0, 112.0),
    (588.0, 166.0),
)
"""The positions of the columns: left edge and width, but for the queues, only the position of their front."""
SLOT, RADIUS = 22.0, 9.5
PALE, DARK = "#d6e6fa", "#173a66"
"""The colors of an item's face and of its number."""
HEAD, SMALL, PLAIN = Font(size=12, bold=True), Font(size=10.5), Font(size=11.5)
FRAME = Paint(stroke=GREY, width=1.4)
UNUSED = Paint(stroke=GREY, width=1.4, dash=(4, 4), alpha=0.7)
QUIET = Paint(stroke=GREY, width=1.2, alpha=0.5)


@dataclass(frozen=True)
class Instant:
    """An instant in a recording: its time (s), a sentence about the event, and the duration of its frame (ms)."""

    t: float
    words: str
    shown_ms: int = 300


def height_of(recording: MachineRecording) -> float:
    """Return the height (px) of a recording's drawing."""
    return TOP + ROW * len(recording.sources) + BOTTOM


def draw(recording: MachineRecording, moment: Instant) -> bytes:
    """Draw a recording at one instant and return PNG bytes."""
    canvas = Canvas(WIDTH, height_of(recording), SCALE)
    _columns(canvas, recording, moment.t)
    running = recording.running(moment.t)
    for place, source in enumerate(recording.sources):
        middle = _middle(place)
        _wires(canvas, recording, place, moment.t)
        _queue(canvas, recording, place, moment.t)
        _lamp(canvas, recording, place, moment.t)
        _callback(canvas, source, middle, [one for one in running if one.source == place], moment.t)
    _executor(canvas, recording, running, moment.t)
    _foot(canvas, recording, moment)
    return canvas.png()


def _middle(place: int) -> float:
    return TOP + ROW * place + ROW / 2


def _columns(canvas: Canvas, recording: MachineRecording, now: float) -> None:
    heads = (
        ("source", DDS[0] + DDS[1] / 2),
        ("queue", QUEUE_END - SLOTS * SLOT / 2),
        ("wait set", WAIT_SET[0] + WAIT_SET[1] / 2),
        ("executor", EXECUTOR[0] + EXECUTOR[1] / 2),
        ("callback", CALLBACK[0] + CALLBACK[1] / 2),
    )
    for words, x in heads:
        canvas.text((x, 17), words, HEAD, align="center")
    high = ROW * len(recording.sources) - 8
    for (left, width), used in ((WAIT_SET, recording.looks(now)), (EXECUTOR, recording.spins(now))):
        canvas.box((left, TOP + 4), (width, high), FRAME if used else UNUSED, radius=8)


def _wires(canvas: Canvas, recording: MachineRecording, place: int, now: float) -> None:
    """Draw the DDS box of a row, or its clock, and the lines along which items travel."""
    middle, source = _middle(place), recording.sources[place]
    left, width = DDS
    if source.kind == "timer":
        center = (left + width / 2, middle + 5)
        canvas.disc(center, 15, FRAME)
        canvas.line([(center[0], center[1] - 10), center, (center[0] + 7, center[1] + 3)], FRAME)
    else:
        canvas.box((left, middle - 10), (width, 30), FRAME, radius=6)
        canvas.text((left + width / 2, middle + 9), "DDS", PLAIN, align="center")
    front = QUEUE_END - SLOT * _slots(source)
    came = any(one.source == place and 0 <= now - one.came < JUST_S for one in recording.items)
    new = Paint(stroke=BLUE, width=2.4)
    for begin, end, paint in (
        (left + width + 3, front - 4, new if came else QUIET),
        (QUEUE_END + 4, WAIT_SET[0] - 3, QUIET),
        (WAIT_SET[0] + WAIT_SET[1] + 3, EXECUTOR[0] - 3, QUIET),
    ):
        _arrow(canvas, (begin, middle + 5), (end, middle + 5), paint)


def _arrow(canvas: Canvas, begin: Point, end: Point, paint: Paint) -> None:
    canvas.line([begin, end], paint)
    x, y = end
    canvas.line([(x - 5, y - 4), end, (x - 5, y + 4)], paint)


def _slots(source: Source) -> int:
    return min(source.depth, SLOTS)


def _queue(canvas: Canvas, recording: MachineRecording, place: int, now: float) -> None:
    source, middle, slots = recording.sources[place], _middle(place), _slots(recording.sources[place])
    waiting = recording.waiting(place, now)
    left = QUEUE_END - SLOT * slots
    canvas.box((left, middle - 7), (SLOT * slots, 24), QUIET, radius=4)
    for slot in range(1, slots):
        x = left + SLOT * slot
        canvas.line([(x, middle - 7), (x, middle + 17)], QUIET)
    for slot, item in enumerate(waiting[:slots]):
        _dot(canvas, (QUEUE_END - SLOT * (slot + 0.5), middle + 5), item, source)
    room = QUEUE_END - DDS[0] - DDS[1] - 8
    canvas.text((QUEUE_END, middle - 13), shorten(_label(source), room, 10.5), SMALL, align="right")
    if source.kind != "timer":
        told = f"{len(waiting)} of {source.depth} wait"
        canvas.text((QUEUE_END, middle + 30), told, SMALL, align="right")
    _losses(canvas, source, recording.lost(place, now), middle + 30, now)


def _losses(canvas: Canvas, source: Source, lost: list[Item], y: float, now: float) -> None:
    """Draw the number of items that a source has lost and, next to it, an item that was lost just now."""
    if not lost:
        return
    words = f"✗ {len(lost)} {'missed' if source.kind == 'timer' else 'thrown away'}"
    right = QUEUE_END - (0 if source.kind == "timer" else 76)
    canvas.text((right, y), words, Font(size=10.5, color=RED), align="right")
    last = lost[-1]
    if last.lost is not None and now - last.lost < JUST_S:
        center = (right - text_width(words, 10.5) - 14, y - 3)
        canvas.disc(center, RADIUS, Paint(fill="#f8dcdc", stroke=RED, width=1.8))
        _number(canvas, center, last.number, source)


def _label(source: Source) -> str:
    if source.kind == "timer":
        return source.name
    word = {"subscription": "", "client": "responses of ", "service": "requests to "}[source.kind]
    return f"{word}{source.name}"


def _dot(canvas: Canvas, center: Point, item: Item, source: Source) -> None:
    canvas.disc(center, RADIUS, Paint(fill=PALE, stroke=BLUE, width=1.8))
    _number(canvas, center, item.number, source)


def _number(canvas: Canvas, center: Point, number: int, source: Source) -> None:
    words = "due" if source.kind == "timer" else str(number)
    size = 8.0 if len(words) > 2 else 10.0
    canvas.text((center[0], center[1] + 3.5), words, Font(size=size, bold=True, color=DARK), align="center")


def _lamp(canvas: Canvas, recording: MachineRecording, place: int, now: float) -> None:
    """Draw the lamp in the wait set: filled if this row has a ready item.

    If the executor doesn't wait on this row, draw a line instead.
    """
    center = (WAIT_SET[0] + WAIT_SET[1] / 2, _middle(place) + 1)
    asked = recording.waits_for(now)
    if not recording.spins(now) or (asked is not None and place not in asked):
        canvas.line([(center[0] - 7, center[1]), (center[0] + 7, center[1])], QUIET)
        return
    ready = bool(recording.waiting(place, now))
    canvas.disc(center, 8, Paint(fill=BLUE if ready else None, stroke=BLUE if ready else GREY, width=1.8))
    if ready:
        canvas.text((center[0], center[1] + 20), "ready", SMALL, align="center")


def _executor(canvas: Canvas, recording: MachineRecording, running: list[Call], now: float) -> None:
    """Draw the executor's threads, and whether each is running a callback."""
    left, width = EXECUTOR
    middle = TOP + ROW * len(recording.sources) / 2
    active = [one for one in running if not one.is_paused(now)]
    lines: list[tuple[str, str]] = []
    if not recording.spins(now):
        lines = [("nobody spins", "")]
    elif recording.threads == 1:
        lines = [("1 thread", "runs" if active else "waits")]
    else:
        free = recording.threads - len(active)
        lines = [(f"thread {place + 1}", "runs") for place in range(len(active))]
        lines.append((f"{free} thread{'s' if free != 1 else ''}", "free"))
    step = 21.0
    first = middle - step * (len(lines) - 1) / 2
    for place, (who, what) in enumerate(lines):
        y = first + step * place
        busy = what == "runs"
        canvas.disc(
            (left + 14, y), 6, Paint(fill=GREEN if busy else None, stroke=GREEN if busy else GREY, width=1.8)
        )
        canvas.text((left + 26, y + 4), f"{who} {what}".strip(), SMALL)
        if busy and place < len(active):
            target = _middle(active[place].source) + 5
            _arrow(canvas, (left + width + 3, y), (CALLBACK[0] - 3, target), Paint(stroke=GREEN, width=2))


def _callback(canvas: Canvas, source: Source, middle: float, running: list[Call], now: float) -> None:
    left, width = CALLBACK
    name = f"{source.callback}()" if source.callback else "the future is done"
    if not running:
        canvas.box((left, middle - 10), (width, 30), QUIET, radius=6)
        canvas.text((left + 12, middle + 9), shorten(name, width - 20, 11.5), PLAIN)
        return
    call = running[0]
    busy = now - call.begin
    paused = call.is_paused(now)
    color = AMBER if busy >= LONG_S else GREEN
    paint = Paint(stroke=color, width=2.6, dash=(5, 4) if paused else None)
    canvas.box((left, middle - 10), (width, 30), paint, radius=6)
    _dot(canvas, (left + 17, middle + 5), Item(call.source, call.number, call.begin), source)
    canvas.text(
        (left + 32, middle + 9), shorten(name, width - 40, 11.5, bold=True), Font(size=11.5, bold=True)
    )
    if paused:
        canvas.text((left + width, middle + 33), "awaits, and its thread is free", SMALL, align="right")
    elif busy >= LONG_S:
        canvas.text((left + width, middle + 33), f"busy for {busy:.1f} s", SMALL, align="right")


def _foot(canvas: Canvas, recording: MachineRecording, moment: Instant) -> None:
    """Draw the line below the rows: the clock, the recording's progress, and the current event."""
    y = height_of(recording) - 34
    left, right = DDS[0] + 66, CALLBACK[0] + CALLBACK[1]
    canvas.text((DDS[0], y + 4), f"{moment.t:.2f} s", HEAD)
    canvas.line([(left, y), (right, y)], QUIET)
    reached = left + (right - left) * min(1.0, max(0.0, moment.t / recording.seconds))
    canvas.line([(left, y), (reached, y)], Paint(stroke=BLUE, width=3))
    canvas.text((DDS[0], y + 25), shorten(moment.words, right - DDS[0], 12.5), Font(size=12.5))
