"""Prepare the robot on a check's card. JupyterLab draws it and moves it according to the recorded messages.

While the judge watches, the robot follows the latest messages. With full marks, it replays a part of the recording. The
front end's code is in workbook/lab/front_end/panel/card.js. In other front ends, readers see a still image.
"""

import contextlib
import json
from bisect import bisect_left
from collections.abc import Iterable, Iterator, Mapping
from types import SimpleNamespace
from typing import Any, NamedTuple

from workbook.grading.slots.protocol import PLUMBING, Progress
from workbook.lab.panel.reactions import MOMENTS, reaction_to
from workbook.lab.panel.robot import PanelRobot
from workbook.lab.panel.traffic import one_line
from workbook.pictures.joints import NEUTRAL, waving
from workbook.recording.recording import Recording

EXCERPT_S = 8.0
"""The length (s) of the replayed excerpt on the recording's clock. The replay takes the same time in real seconds."""
TICK_S = 0.1
"""In each interval of this length (s), only a topic's last message moves the robot."""
LARGEST_REPLAY = 40_000
"""The size limit of a replay, in characters of JSON. The limit exists because the notebook stores the replay."""
WAVE_S = 2.7
FAST_GLIDE_MS = 110
"""The duration (ms) of the robot's glide to a new pose while the judge watches. Updates arrive four times a second."""
GLIDES_MS = (70, 300)
"""The shortest and the longest duration (ms) of a glide to a pose in a replay."""
MOVES_NOW = "Your program's messages move the robot."
MOVED = "A replay: your program's messages moved the robot like this."
_PER_GLIDE = 5
_DIGITS = 3
_MOVES_NOTHING = {"awake", "words"}

Event = tuple[int, dict[str, object]]
"""A time (ms), and the changes to the robot at that time."""


def _message(value: object) -> Any:
    """Convert a message, stored as plain data, to an object with attributes."""
    return json.loads(json.dumps(value), object_hook=lambda fields: SimpleNamespace(**fields))


def _line(value: Mapping[str, object]) -> str:
    return one_line("\n".join(f"{name}: {content}" for name, content in value.items()))


def _take(robot: PanelRobot, topic: str, type_name: str, value: object, now: float) -> None:
    """Have the robot react to a message. If a message doesn't fit its type, the robot ignores it.

    A message without an effect on the robot is shown only if it's a number or a word. Longer messages would fill the
    line below the robot.
    """
    if not isinstance(value, Mapping) or topic.startswith(PLUMBING):
        return
    if _effect(topic, type_name) is None and isinstance(value.get("data", {}), Mapping):
        return
    with contextlib.suppress(TypeError, AttributeError):
        robot.take(topic, type_name, _message(value), _line(value), now)


def _rounded(value: object) -> object:
    if isinstance(value, float):
        return round(value, _DIGITS)
    return [_rounded(one) for one in value] if isinstance(value, (list, tuple)) else value


def _news(robot: PanelRobot, now: float) -> dict[str, object]:
    news = robot.news(now) if robot.awake else {}
    return {name: _rounded(value) for name, value in news.items() if name != "text"}


class WatchedRobot:
    """The robot while the judge watches. It follows the slot's progress reports."""

    def __init__(self) -> None:
        self._robot = PanelRobot()
        self._counts: dict[str, int] = {}
        self._state: dict[str, object] = {}

    def after(self, progress: Progress, now: float) -> dict[str, object]:
        """Return the update for card.js: the robot's lasting state and its latest momentary effects.

        `now`: the monotonic time in seconds.
        """
        for topic, count in progress.messages.items():
            value = progress.latest.get(topic)
            if count != self._counts.get(topic):
                _take(self._robot, topic, progress.types.get(topic, ""), value, now)
            self._counts[topic] = count
        news = _news(self._robot, now)
        self._state |= {name: value for name, value in news.items() if name not in MOMENTS}
        return {"news": {"text": MOVES_NOW, **self._state, **news}, "glide": FAST_GLIDE_MS}


class _Seen(NamedTuple):
    """One message of a recording."""

    t: float
    topic: str
    type_name: str
    value: object


def _messages(recording: Recording) -> list[_Seen]:
    """Return the program's messages and the responses to calls in chronological order, at most one per topic and tick.

    The judge's messages are included, unless the program's own messages have the same effect on the robot.
    """
    found: dict[tuple[str, int], _Seen] = {}
    own = set()
    for topic in recording.with_publishers():
        own.add(_effect(topic.name, topic.types[0]))
        for arrival in topic.arrivals:
            seen = _Seen(arrival.t, topic.name, topic.types[0], arrival.value)
            found[topic.name, int(arrival.t / TICK_S)] = seen
    for said in recording.published:
        types = [one.type for one in recording.topic(said.topic).subscribers]
        if types and _effect(said.topic, types[0]) not in own | {None}:
            found[said.topic, int(said.t / TICK_S)] = _Seen(said.t, said.topic, types[0], said.value)
    types_of_services = {one.name: one.type for one in recording.services + recording.clients}
    for call in recording.calls:
        if call.answered_t is not None and (type_name := types_of_services.get(call.service)):
            response = _Seen(call.answered_t, call.service, type_name, call.response)
            found[call.service, int(call.answered_t / TICK_S)] = response
    return sorted(found.values(), key=lambda one: one.t)


def _effect(topic: str, type_name: str) -> str | None:
    reaction = reaction_to(topic, type_name)
    return None if reaction is None else reaction.effect


def _all_events(messages: Iterable[_Seen]) -> Iterator[tuple[float, dict[str, object]]]:
    robot = PanelRobot()
    for seen in messages:
        _take(robot, seen.topic, seen.type_name, seen.value, seen.t)
        if news := _news(robot, seen.t):
            yield seen.t, news


def _liveliest(events: list[tuple[float, dict[str, object]]]) -> int:
    """Return the index of the event at which the excerpt with the most different effects begins.

    Ties go to the earliest excerpt.
    """

    def shown(first: int) -> int:
        last = bisect_left(events, events[first][0] + EXCERPT_S, key=lambda event: event[0])
        effects = [
            (name, str(value))
            for _, news in events[first:last]
            for name, value in news.items()
            if name not in _MOVES_NOTHING
        ]
        # An effect that changes again and again, such as a pose, counts at most three times.
        names = [name for name, _ in set(effects)]
        return sum(min(3, names.count(name)) for name in set(names))

    starts = range(0, len(events), max(1, len(events) // 60))
    return max(starts, key=lambda first: (shown(first), -first))


def _bounded(events: list[Event]) -> list[Event]:
    """Cut off the end of a replay if it's too large for a notebook."""
    size = 0
    for number, event in enumerate(events):
        size += len(json.dumps(event))
        if size > LARGEST_REPLAY:
            return events[:number]
    return events


def _glide(events: list[Event]) -> int:
    """Return the time (ms) that the robot takes to reach a pose. It's longer if poses arrive less often."""
    poses = [moment for moment, news in events if "pose" in news]
    gaps = sorted(later - earlier for earlier, later in zip(poses, poses[1:], strict=False))
    fastest, slowest = GLIDES_MS
    return min(slowest, max(fastest, gaps[len(gaps) // 2] // _PER_GLIDE)) if gaps else fastest


def _wave() -> dict[str, object]:
    ticks = range(round(WAVE_S / TICK_S))
    poses = [*(waving(TICK_S * tick) for tick in ticks), NEUTRAL]
    events: list[Event] = [
        (round(1000 * TICK_S * tick), {"pose": _rounded(pose)}) for tick, pose in enumerate(poses)
    ]
    events[0][1].update(awake=True, text="The robot waves.")
    return {"events": events, "glide": GLIDES_MS[0]}


def replay_of(recording: Recording) -> dict[str, object]:
    """Convert a recording to a replay: the robot's `events` with their times (ms), and its `glide` (ms).

    If nothing in the recording would move the robot, the replay shows a wave of its hand.
    """
    events = list(_all_events(_messages(recording)))
    if not any(set(news) - _MOVES_NOTHING for _, news in events):
        return _wave()
    first = _liveliest(events)
    began = events[first][0]
    before: dict[str, object] = {}
    for _, news in events[:first]:
        before |= {name: value for name, value in news.items() if name not in MOMENTS}
    chosen = [(round(1000 * (t - began)), news) for t, news in events[first:] if t < began + EXCERPT_S]
    chosen[0] = (0, {**before, **chosen[0][1], "awake": True, "text": MOVED})
    replay = _bounded(chosen)
    return {"events": replay, "glide": _glide(replay)}
