"""Make strange recordings of any kind that a program could cause, from recordings of right answers.

`python -m tests.criteria.any_recording` records the right answers: one watch of each solution. They may be of older
scripts, because criteria must tolerate every recording.
"""

import gzip
import json
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

from workbook.exercise.answers import Answer
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.source import stems
from workbook.recording.recording import (
    Arrival,
    CallSeen,
    Finding,
    NodeSeen,
    ProcessRecord,
    Published,
    PublisherSeen,
    Recording,
    ServiceSeen,
    Stretch,
    SubscriberSeen,
    TopicRecording,
)
from workbook.recording.script import BEFORE_START

ROOT = Path(__file__).resolve().parents[2]
FOLDER = Path(__file__).parent / "recordings"
MOST_MESSAGES = 20_000
"""The same as in `workbook.watching.recorder`, which needs ROS."""
MOST_CALLS = 2_000
"""The limit per service, as many as a program makes that waits for each response."""
STRANGE_FLOATS = (
    math.nan,
    math.inf,
    -math.inf,
    0.0,
    -0.0,
    1e38,
    -1e38,
    1e-45,
    5e-324,
    1e300,
    0.5,
    -1.0,
    12.0,
)
STRANGE_INTS = (0, 1, -1, 127, -128, 255, 2**31 - 1, -(2**31), 2**63 - 1, 2**64 - 1)
STRANGE_TEXTS = (
    "",
    " ",
    "ok",
    "nan",
    "-",
    "1 2 3",
    "{}",
    "%s%d{0}",
    "\x1b[2J",
    "\u202eabc",
    "\u0661\u0662",
    "1e999",
    "9" * 400,
    "-1",
    "[" * 200,
    "a" * 4096,
    "key=value " * 300,
    "Traceback (most recent call last):",
)
TYPES = (
    "std_msgs/msg/String",
    "std_msgs/msg/Float32",
    "std_msgs/msg/Float64",
    "std_msgs/msg/Float32MultiArray",
    "geometry_msgs/msg/Twist",
    "sensor_msgs/msg/Image",
    "nowhere/msg/Unknown",
)
LOG_LINES = (
    "Traceback (most recent call last):",
    '  File "answer.py", line 3, in <module>',
    '  File "/usr/lib/python3/rclpy/node.py", line 1, in spin',
    "    self.publisher.publish(message)",
    "AssertionError: The 'data' field must be a set or sequence and each value of type 'float'",
    "AttributeError: 'NoneType' object has no attribute 'publish'",
    "During handling of the above exception, another exception occurred:",
    "KeyboardInterrupt",
    "rclpy.executors.ExternalShutdownException",
    "[INFO] [1700000000.0] [node]: 12",
    "ImportError: No module named ' " + "' " * 900,
    "( " * 1000,
    "a" * 3000,
    "E: " + ": " * 900,
    "'" * 500,
    "\u2028\u202e\x00\ud7ff",
)


@cache
def right(stem: str) -> Recording:
    """Load the recording of an exercise's solution.

    If its script is drawn, the recording needs a seed for the criteria.
    """
    stored = Recording.from_json(json.loads(gzip.decompress((FOLDER / f"{stem}.json.gz").read_bytes())))
    return stored if stored.seed is not None else replace(stored, seed=load_exercise(stem).drawn(1).plan.seed)


def bytes_of(value: Any) -> int:
    """Estimate the bytes that a message takes of its topic's quota, too few rather than too many."""
    if isinstance(value, dict):
        large = value.get("length", 0) // 1000 if "first" in value else 0
        return large + sum(map(bytes_of, value.values()))
    if isinstance(value, list):
        return 4 + sum(map(bytes_of, value))
    return 4 + len(value) if isinstance(value, str) else 1 if isinstance(value, bool) else 4


class Flood:
    """Fills a recording up to its quotas. `times` draws a moment of the watch (s)."""

    def __init__(self, exercise: Exercise, random: Random, times: Callable[[Random, float], float]) -> None:
        self._plan, self._random, self._times = exercise.plan, random, times

    def flooded(self, recording: Recording, change: Callable[[Any], Any]) -> Recording:
        """Return the recording with its messages repeated up to the quota; `change` makes each value new."""
        topics = {
            name: replace(one, arrivals=self._arrivals(one, recording, change))
            for name, one in recording.topics.items()
        }
        return replace(recording, topics=topics, calls=self._calls(recording))

    def _arrivals(
        self, topic: TopicRecording, recording: Recording, change: Callable[[Any], Any]
    ) -> tuple[Arrival, ...]:
        if not topic.arrivals or not topic.publishers:
            return topic.arrivals
        room, found = self._plan.bytes_per_topic, list[tuple[float, Any]]()
        while len(found) < MOST_MESSAGES:
            value = change(topic.arrivals[len(found) % len(topic.arrivals)].value)
            room -= bytes_of(value)
            if room < 0:
                break
            found.append((self._times(self._random, recording.watched_s), value))
        offset = topic.arrivals[0].wall - topic.arrivals[0].t
        return tuple(
            Arrival(t, t + offset, value, t + offset - 0.001)
            for t, value in sorted(found, key=lambda one: one[0])
        )

    def _calls(self, recording: Recording) -> tuple[CallSeen, ...]:
        calls = [one for one in recording.calls if one.by == "program"]
        if not calls:
            return recording.calls
        more = []
        for number in range(MOST_CALLS):
            one, t = calls[number % len(calls)], self._times(self._random, recording.watched_s)
            later = None if one.answered_t is None else t + one.answered_t - one.t
            more.append(replace(one, t=t, wall=t, answered_t=later, answered_wall=later))
        others = [one for one in recording.calls if one.by != "program"]
        return tuple(sorted([*others, *more], key=lambda call: call.wall))


def evenly(random: Random, end: float) -> float:
    """Draw a moment anywhere in a watch that ends at `end` (s)."""
    return random.uniform(0.0, end)


def in_one_burst(random: Random, end: float) -> float:
    """Draw a moment within one hundredth of a second."""
    return end / 2 + random.uniform(0.0, 0.01)


def in_bursts(random: Random, end: float) -> float:
    """Draw a moment within one of ten bursts."""
    return random.randrange(10) * end / 10 + random.uniform(0.0, 0.001)


class Strange:
    """Draws changes of a recording that the exercise's watch could have recorded."""

    def __init__(self, exercise: Exercise, random: Random) -> None:
        self._exercise, self._random = exercise, random

    def _one(self, choices: Any) -> Any:
        return self._random.choice(choices)

    def _seldom(self) -> bool:
        return self._random.random() < 0.2

    def value(self, value: Any) -> Any:
        """Return a value of the same message type, perhaps with other numbers, texts, and array lengths."""
        if self._random.random() < 0.5:
            return value
        if isinstance(value, dict):
            changed = {
                key: self.value(item) for key, item in value.items() if key not in ("sha256", "length")
            }
            if "features" in value and self._seldom():
                changed["features"] = None
            return {**value, **changed}
        if isinstance(value, list):
            return self._list([self.value(item) for item in value])
        if isinstance(value, bool):
            return not value
        if isinstance(value, int):
            return self._one(STRANGE_INTS)
        if isinstance(value, float):
            return self._one(STRANGE_FLOATS)
        return self._one(STRANGE_TEXTS) if isinstance(value, str) else value

    def _list(self, items: list[Any]) -> list[Any]:
        return self._one((items, items[:-1], items + items[:1], [], items[:1] * 300, items[::-1], items[:1]))

    def foreign(self) -> tuple[str, Any]:
        """Return another message type, and a value of it."""
        numbers = [self._one(STRANGE_FLOATS) for _ in range(self._random.randrange(4))]
        return self._one(
            (
                ("std_msgs/msg/String", {"data": self._one(STRANGE_TEXTS)}),
                ("std_msgs/msg/Float64", {"data": self._one(STRANGE_FLOATS)}),
                ("std_msgs/msg/Int32", {"data": self._one(STRANGE_INTS)}),
                ("std_msgs/msg/Bool", {"data": True}),
                ("std_msgs/msg/Empty", {"structure_needs_at_least_one_member": 0}),
                (
                    "std_msgs/msg/Float32MultiArray",
                    {"layout": {"dim": [], "data_offset": 0}, "data": numbers},
                ),
                ("std_msgs/msg/String", {"data": {"length": 5000, "sha256": "0" * 64, "first": "a" * 4096}}),
                (
                    "std_msgs/msg/Float32MultiArray",
                    {"layout": {"dim": [], "data_offset": 0}, "data": {"length": 5000, "first": numbers}},
                ),
            )
        )

    def topic(self, topic: TopicRecording, end: float) -> TopicRecording:
        """Return the topic as another program might use it. `end`: the end of the watch (s)."""
        for change in self._random.sample(self._topic_changes(), self._random.randrange(4)):
            topic = change(topic, end)
        return topic

    def _topic_changes(self) -> list[Callable[[TopicRecording, float], TopicRecording]]:
        return [
            lambda one, _: replace(
                one, arrivals=tuple(replace(it, value=self.value(it.value)) for it in one.arrivals)
            ),
            lambda one, _: replace(one, arrivals=()),
            lambda one, _: replace(one, arrivals=one.arrivals[: self._random.randrange(4)]),
            lambda one, _: replace(one, arrivals=one.arrivals[self._random.randrange(20) :]),
            lambda one, _: replace(
                one, arrivals=tuple(it for it in one.arrivals if self._random.random() < 0.5)
            ),
            lambda one, _: replace(one, arrivals=tuple(it for it in one.arrivals for _ in range(3))),
            lambda one, _: replace(
                one, arrivals=tuple(replace(it, t=one.arrivals[0].t, wall=0.1) for it in one.arrivals)
            ),
            lambda one, _: replace(one, arrivals=tuple(replace(it, sent=None) for it in one.arrivals)),
            self._of_another_type,
            lambda one, _: replace(one, publishers=()),
            lambda one, _: replace(one, publishers=(*one.publishers, *self._publishers())),
            lambda one, _: replace(one, publishers=tuple(self._publishers())),
            lambda one, _: replace(one, subscribers=()),
            lambda one, _: replace(one, subscribers=(*one.subscribers, *self._subscribers())),
            lambda one, _: replace(one, window=None),
            lambda one, end: replace(one, window=(end, end)),
            lambda one, _: replace(one, undecodable=3, broken_at=0.5),
            lambda one, end: replace(one, not_kept=2000, full_at=end / 2, room=self._one((None, 1_000_000))),
            lambda one, _: replace(one, not_kept=7, too_large=7, broken_at=1.0, arrivals=()),
        ]

    def _of_another_type(self, topic: TopicRecording, end: float) -> TopicRecording:
        kind, value = self.foreign()
        return replace(
            topic,
            publishers=tuple(replace(one, type=kind) for one in topic.publishers),
            arrivals=tuple(replace(one, value=value) for one in topic.arrivals),
        )

    def _name(self) -> str:
        return self._one(
            ("/humanoid", "/", "/a/b/c", "/" + "n" * 250, "/talker", f"/node_{self._random.random()}")
        )

    def _node(self) -> NodeSeen:
        return NodeSeen(self._name(), 0.1, self._one((1, 2, 9)), self._stayed())

    def _stayed(self) -> bool | None:
        return self._seldom() if self._exercise.to_the_end else None

    def _publishers(self) -> Iterator[PublisherSeen]:
        for _ in range(self._one((1, 2, 60))):
            yield PublisherSeen(
                self._name(),
                self._one(TYPES),
                self._one(("reliable", "best_effort", "unknown")),
                self._one(("volatile", "transient_local", "unknown")),
                self._one((0.0, 3.0)),
                self._one((None, 5.0)),
                self._one((None, 0.0, 0.1, 1e9)),
            )

    def _subscribers(self) -> Iterator[SubscriberSeen]:
        for one in self._publishers():
            yield SubscriberSeen(one.node, one.type, one.reliability, one.durability, one.deadline)

    def recording(self, recording: Recording) -> Recording:
        """Return the same watch of another program."""
        topics = {name: self.topic(one, recording.watched_s) for name, one in recording.topics.items()}
        if self._seldom() and topics:
            del topics[self._one(list(topics))]
        if self._seldom():
            topics |= self._more_topics(recording)
        recording = replace(recording, topics=topics)
        for change in self._random.sample(self._changes(), self._random.randrange(4)):
            recording = change(recording)
        return recording

    def _more_topics(self, recording: Recording) -> dict[str, TopicRecording]:
        """Add topics whose names resemble those that are wanted, or don't."""
        found = {}
        for number in range(self._one((1, 3, 60))):
            base = self._one([*recording.topics, "/x"])
            name = self._one((f"{base}s", base.upper(), f"/humanoid{base}", f"/t{number}", base[:-1] or "/y"))
            kind, value = self.foreign()
            arrivals = tuple(Arrival(t / 10, t / 10, value) for t in range(self._one((0, 1, 30))))
            seen = PublisherSeen(self._name(), kind, "reliable", "volatile", 0.0)
            found[name] = TopicRecording(name, (seen,), (), arrivals, (0.0, recording.watched_s))
        return found

    def _changes(self) -> list[Callable[[Recording], Recording]]:
        return [
            lambda one: replace(one, nodes=()),
            lambda one: replace(one, nodes=tuple(self._node() for _ in range(300))),
            lambda one: replace(one, nodes=tuple(replace(it, stayed=self._stayed()) for it in one.nodes)),
            lambda one: replace(one, process=self._process(one.process)),
            lambda one: replace(one, process=self._process(one.process)),
            lambda one: replace(one, clock=self._one(("wall", "simulated")), step_s=self._one((None, 0.05))),
            lambda one: replace(
                one, follows_clock=self._one((None, True, False)), in_lockstep=self._seldom()
            ),
            lambda one: replace(one, following={name: self._seldom() for name in one.topics}),
            lambda one: replace(one, watched_s=self._one((0.0, 1.0, one.watched_s / 2)), stretches=()),
            lambda one: replace(one, stretches=(Stretch(1.0, 0.0, 1.0), Stretch(20.0, 1.0, one.watched_s))),
            lambda one: replace(one, published=tuple(self._begin_of(one.published))),
            lambda one: replace(one, calls=()),
            lambda one: replace(one, calls=one.calls[: self._random.randrange(len(one.calls) + 1)]),
            lambda one: replace(one, calls=tuple(self._call(it) for it in one.calls)),
            lambda one: replace(one, services=(), clients=()),
            lambda one: replace(one, services=tuple(self._services()), clients=tuple(self._services())),
            lambda one: replace(one, findings=one.findings and ()),
            lambda one: replace(one, findings=one.findings and tuple(self._findings(one))),
            lambda one: replace(one, held_up_s=3.0, stood_still_s=2.0, taken_s=5.0, in_line_s=9.0),
            lambda one: replace(one, notes=(self._log(), "field checks: "), wanted=()),
        ]

    def _begin_of(self, said: Sequence[Published]) -> Iterator[Published]:
        """Return the messages published until the watch ended early, and always those from before the start."""
        left = self._random.randrange(len(said) + 1)
        return (one for place, one in enumerate(said) if place < left or one.t <= BEFORE_START)

    def _call(self, call: CallSeen) -> CallSeen:
        if self._seldom():
            return replace(call, response=None, answered_t=None, answered_wall=None)
        if call.by == "judge" and call.response is not None:
            return replace(call, response=self.value(call.response))
        return replace(call, request=self.value(call.request)) if call.by == "program" else call

    def _services(self) -> Iterator[ServiceSeen]:
        for _ in range(self._one((1, 40))):
            yield ServiceSeen(
                self._one((self._name(), "/robot/self_test", "/self_test")),
                self._one(("std_srvs/srv/Trigger", "std_srvs/srv/SetBool", "nowhere/srv/Unknown")),
            )

    def _findings(self, recording: Recording) -> Iterator[Finding]:
        probes = ["", *{one.probe for one in recording.findings or ()}]
        codes = (
            "attr-defined",
            "arg-type",
            "no-untyped-def",
            "silenced",
            "unchecked",
            "unfinished",
            "syntax",
            "x-y",
        )
        for _ in range(self._one((1, 5, 400))):
            yield Finding(
                self._one(probes), self._one((0, 1, 10**6)), self._one(codes), self._one(STRANGE_TEXTS)
            )

    def _log(self) -> str:
        return "\n".join(self._one(LOG_LINES) for _ in range(self._random.randrange(60)))[:8000]

    def _process(self, process: ProcessRecord) -> ProcessRecord:
        by_itself = self._random.random() < 0.6
        signal = self._one((None, "SIGKILL", "SIGSEGV", "SIGXCPU", "SIG99"))
        return replace(
            process,
            exit=None if signal else self._one((0, 1, 2, 120, 255)),
            signal=signal,
            ended_at=self._one((None, 0.0, 1.5, 9.0)),
            ended_by="itself" if by_itself else "judge",
            limits_hit=self._one(((), ("memory",), ("output", "processes"), ("nothing we know",))),
            log=self._log(),
            end_log=self._log(),
            log_truncated=self._seldom(),
            domains_used=self._one(((), (0,), (17, 42))),
            processor=self._one(((), ((1.0, 0.0),), ((0.0, 0.0), (0.0, 0.0)), ((1.0, 1.0), (9.0, 50.0)))),
            printed_at=self._one((None, 0.0, 8.0)),
        )


def main() -> None:
    """Watch the solution of each exercise and keep the recording."""
    from workbook.exercise.judging import Judge
    from workbook.watching.observer import Observer

    with Observer() as observer:
        for stem in stems(ROOT / "solutions"):
            exercise = load_exercise(stem, ROOT)
            recording = Judge(observer).judge(exercise, Answer(exercise.source.solution_code)).recording
            assert recording is not None
            data = json.dumps(recording.to_json(), allow_nan=False, separators=(",", ":"))
            (FOLDER / f"{stem}.json.gz").write_bytes(gzip.compress(data.encode(), mtime=0))


if __name__ == "__main__":
    main()
