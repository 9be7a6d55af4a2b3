"""Make a film of a recorded machine: choose the instants, describe each, and draw the frames.

Time is stretched: ten callbacks within a millisecond get a frame each, but a second without changes gets only a few.
The clock in each frame shows the recorded time.
"""

import io
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from PIL import Image

from workbook.pictures.film import moving_png
from workbook.pictures.machine import SCALE, Instant, draw
from workbook.pictures.png import data_uri, size_on_screen
from workbook.pictures.stills import MimeBundle, Still
from workbook.recording.machine import Call, Item, MachineRecording
from workbook.templating import render

SOON_S = 0.02
"""If a tick is served within this time (s), the film has no separate frame for the tick, only one for its callback."""
LOOK_S = 0.25
"""While nothing new happens, there is a frame about this often."""
SHORTEST_MS, LONGEST_MS, LAST_MS = 320, 700, 2500
MOST = 64
"""The largest number of frames in a film. Later instants are left out."""
STEPS = 6
"""The number of frames in the column for readers who prefer no motion."""


@dataclass(frozen=True, repr=False)
class MovingMachine(Still):
    """A film of the machine, with stills for readers who prefer no motion.

    `still` is the film's fullest frame, and `steps` is a column of six frames.
    """

    still: bytes = b""
    steps: bytes = b""

    def _repr_mimebundle_(self, include: Any = None, exclude: Any = None) -> MimeBundle:
        bundle, metadata = super()._repr_mimebundle_(include, exclude)
        width, height = size_on_screen(self.png)
        _, high = size_on_screen(self.steps)
        bundle["text/html"] = render(
            "pictures/machine",
            alt=self.description,
            width=width,
            height=height,
            steps_height=high,
            film=data_uri(self.png),
            still=data_uri(self.still),
            steps=data_uri(self.steps),
        )
        return bundle, metadata


def play(
    recording: MachineRecording, description: str, begin: float = 0.0, end: float | None = None
) -> MovingMachine:
    """Make the film of a recording from `begin` to `end` (s).

    Raises ValueError if nothing happened in that time.
    """
    chosen = moments(recording, begin, recording.seconds if end is None else end)
    if len(chosen) < 2:
        raise ValueError("nothing happened in this time: no message arrived, and no timer was due")
    frames = [draw(recording, moment) for moment in chosen]
    film = moving_png(frames, durations_ms=[one.shown_ms for one in chosen], dots_per_pixel=SCALE)
    last = len(frames) - 1
    picked = [frames[round(place * last / (STEPS - 1))] for place in range(STEPS)]
    fullest = max(range(len(chosen)), key=lambda place: _busy(recording, chosen[place].t))
    return MovingMachine(film, description, still=frames[fullest], steps=_one_below_another(picked))


def _busy(recording: MachineRecording, now: float) -> int:
    """Return the number of waiting items plus the number of running callbacks at the time `now` (s)."""
    waiting = sum(len(recording.waiting(place, now)) for place in range(len(recording.sources)))
    return waiting + len(recording.running(now))


def moments(recording: MachineRecording, begin: float, end: float) -> list[Instant]:
    """Return the instants that get a frame, in order. If there are more than 64, return the first 64."""
    found = [one for one in sorted(_events(recording)) if begin <= one[0] <= end]
    told = [(begin, ""), *found, (end, "")]
    filled: list[tuple[float, str]] = []
    for (t, words), (following, _) in pairwise(told):
        filled.append((t, words))
        gap = following - t
        extra = int(gap / LOOK_S) if gap > 1.5 * LOOK_S else 0
        filled += [(t + gap * place / (extra + 1), "") for place in range(1, extra + 1)]
    filled = filled[:MOST]
    times = [t for t, _ in filled] + [end]
    shown = [
        min(LONGEST_MS, max(SHORTEST_MS, round(1000 * (after - before)))) for before, after in pairwise(times)
    ]
    shown[-1] = LAST_MS
    return [
        Instant(t, words or _meanwhile(recording, t), ms)
        for (t, words), ms in zip(filled, shown, strict=True)
    ]


def _events(recording: MachineRecording) -> list[tuple[float, str]]:
    events = [one for item in recording.items if (one := _came(recording, item)) is not None]
    events += [(call.begin, _called(recording, call)) for call in recording.calls]
    events += [
        (item.lost, _missed(recording, item))
        for item in recording.items
        if item.lost is not None and recording.sources[item.source].kind == "timer"
    ]
    return events


def _came(recording: MachineRecording, item: Item) -> tuple[float, str] | None:
    source = recording.sources[item.source]
    if source.kind == "timer":
        served = recording.seconds if item.taken is None else item.taken
        if item.lost is not None or served - item.came < SOON_S:
            return None
        return item.came, f"The timer of {source.callback} is due. Its callback has to wait."
    out = [one for one in recording.items if one.source == item.source and one.lost == item.came]
    if out:
        return (
            item.came,
            f"Message {item.number} comes. The queue is full: message {out[0].number} is thrown away.",
        )
    what = {"client": "Response", "service": "Request"}.get(source.kind, "Message")
    return item.came, f"{what} {item.number} comes, and waits in the queue."


def _missed(recording: MachineRecording, item: Item) -> str:
    source = recording.sources[item.source]
    return f"The timer of {source.callback} is due again, but one tick waits already: this tick is missed."


def _called(recording: MachineRecording, call: Call) -> str:
    source = recording.sources[call.source]
    if source.kind == "client":
        return f"The executor takes response {call.number} and puts it into its future."
    if source.kind == "timer":
        return f"The timer is due: the executor calls {source.callback}."
    what = "request" if source.kind == "service" else "message"
    return f"The executor takes {what} {call.number} and calls {source.callback} with it."


def _meanwhile(recording: MachineRecording, now: float) -> str:
    """Describe an instant at which nothing new happens."""
    running = [one for one in recording.running(now) if not one.is_paused(now)]
    if running:
        names = " and ".join(recording.sources[one.source].callback or "a response" for one in running)
        verb = "run" if len(running) > 1 else "runs"
        waits = any(recording.waiting(place, now) for place in range(len(recording.sources)))
        return f"{names} {verb}. {'Ready callbacks have to wait.' if waits else 'Nothing else is ready.'}"
    if not recording.spins(now):
        return "No thread is in spin. New messages wait in their queues."
    asked = recording.waits_for(now) or ()
    if any(recording.waiting(place, now) for place in asked):
        return "Something is ready. The executor takes it next."
    return "The executor waits in the wait set. Nothing that it asks for is ready."


def _one_below_another(frames: Sequence[bytes]) -> bytes:
    """Arrange frames of one size in a column, reduced to the few colors of a drawing. Return PNG bytes."""
    pictures = [Image.open(io.BytesIO(frame)).convert("RGBA") for frame in frames]
    width, height = pictures[0].size
    sheet = Image.new("RGBA", (width, height * len(pictures)))
    for place, picture in enumerate(pictures):
        sheet.paste(picture, (0, place * height))
    file = io.BytesIO()
    few = sheet.quantize(64, method=Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    few.save(file, "PNG", optimize=True, dpi=(96 * SCALE,) * 2)
    return file.getvalue()
