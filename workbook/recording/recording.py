"""Define the recording of a program's run: the nodes' messages, with times, and the behavior of the process.

A recording is plain data, made once and stored as JSON. Figures, verdicts, and feedback are derived from it. A watch is
the part of the run in which the judge observes the program. Fields named `t` are simulated times (s) since the watch
began, and fields named `wall` are real times (s) since the program was started.
"""

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, ClassVar, Literal

from workbook.recording.codec import ALWAYS_STORED, STORED_IF_SET, Malformed, decode, encode, stored_as

FORMAT: Literal[1] = 1

Clock = Literal["simulated", "wall"]


@dataclass(frozen=True)
class Arrival:
    """One message as it arrived. `value` contains its fields as plain data, e.g. `{"data": 99.5}`.

    `t` and `wall` are its arrival times. `sent` is the wall time (s) at which the program published it, or None in old
    recordings. It comes from the timestamp that DDS adds to every message.
    """

    t: float
    wall: float
    value: Any
    sent: float | None = None
    ignores_unknown_fields: ClassVar[bool] = True

    @property
    def published(self) -> float:
        """The wall time (s) at which the program published the message, or its arrival time if the former is unknown.

        DDS resends lost messages, so messages on two topics may arrive in a different order than they were published.
        To find out which message came first or which message caused another, compare these times, not the arrival
        times.
        """
        return self.wall if self.sent is None else self.sent


@dataclass(frozen=True)
class PublisherSeen:
    """A publisher in the graph: its node's fully qualified name, its type, its QoS, and when the judge saw it.

    `deadline` and `lifespan` are in seconds, or None if there is no such limit. `last_seen` is None if the publisher
    was still there when the watch ended.
    """

    node: str
    type: str
    reliability: str
    durability: str
    first_seen: float
    last_seen: float | None = None
    deadline: float | None = None
    lifespan: float | None = None


@dataclass(frozen=True)
class SubscriberSeen:
    """A subscription in the graph: its node's fully qualified name, its type, and its QoS.

    `deadline` is in seconds, or None if the subscription requests none.
    """

    node: str
    type: str
    reliability: str
    durability: str
    deadline: float | None = None


@dataclass(frozen=True)
class TopicRecording:
    """The recording of one topic.

    `window`: the start and end (s) of its watch, which begins when the judge's subscription is matched. `undecodable`:
    the number of messages whose bytes don't fit the type. `not_kept`: the number of messages that arrived but aren't
    stored; `too_large` of them exceeded the size limit. `broken_at`: the simulated time (s) at which the first
    undecodable or too large message arrived, or None if there was none. `full_at`: the simulated time (s) at which this
    topic's quota was used up, or None if it never was. `room`: the topic's quota in bytes, or None if the quota that
    was used up was the number of messages. `kept`: the number of earlier messages that a late subscription received.
    It's None if there was no such subscription, or if new messages arrived in the meantime.
    """

    name: str
    publishers: tuple[PublisherSeen, ...] = field(default=(), metadata=ALWAYS_STORED)
    subscribers: tuple[SubscriberSeen, ...] = field(default=(), metadata=ALWAYS_STORED)
    arrivals: tuple[Arrival, ...] = field(default=(), metadata=ALWAYS_STORED)
    window: tuple[float, float] | None = field(default=None, metadata=ALWAYS_STORED)
    undecodable: int = field(default=0, metadata=ALWAYS_STORED)
    not_kept: int = field(default=0, metadata=ALWAYS_STORED)
    too_large: int = 0
    broken_at: float | None = None
    full_at: float | None = None
    room: int | None = None
    kept: int | None = None
    ignores_unknown_fields: ClassVar[bool] = True

    @property
    def types(self) -> tuple[str, ...]:
        """The message types of the topic's publishers, sorted and without duplicates."""
        return tuple(sorted({publisher.type for publisher in self.publishers}))


@dataclass(frozen=True)
class NodeSeen:
    """A node in the graph: its fully qualified name and the wall time (s) at which it appeared.

    `most`: the largest number of nodes with this name that existed at the same time. `stayed`: whether the node was
    still in the graph after the program had exited, or None if the judge didn't watch the graph then.
    """

    name: str
    first_seen: float
    most: int = 1
    stayed: bool | None = None


@dataclass(frozen=True)
class Published:
    """One message of the script, as the judge published it. `value` contains its fields as plain data, as in `Arrival`.

    `t` and `wall`: the simulated and the wall time (s) just before the judge published it.
    """

    topic: str
    t: float
    wall: float
    value: Any
    ignores_unknown_fields: ClassVar[bool] = True


@dataclass(frozen=True)
class CallSeen:
    """One service call. `by`: the caller, which is "program" or "judge".

    `response`, `answered_t`, and `answered_wall` are None if there was no response.
    """

    service: str
    by: Literal["program", "judge"]
    t: float
    wall: float
    request: Any
    response: Any = None
    answered_t: float | None = None
    answered_wall: float | None = None


@dataclass(frozen=True)
class ServiceSeen:
    """A service that the program offers or has a client for: its fully qualified name and its type."""

    name: str
    type: str


SILENCED, UNCHECKED, UNFINISHED = "silenced", "unchecked", "unfinished"
"""The codes of findings that we add: comments that silence mypy, code that mypy skips, and an unfinished mypy run."""


@dataclass(frozen=True)
class Finding:
    """One message from the type checker about the program or a probe, which is code that uses the program.

    `probe`: the probe's name, or "" for the program. `line`: the line number, starting at 1, or 0 if the finding isn't
    about a single line.
    """

    probe: str
    line: int
    code: str
    message: str


@dataclass(frozen=True)
class SpinSeen:
    """A source line that spins a node and may be the reason why nothing is published: `code` at `line` (from 1).

    `callback`: the callback that contains this line, or "" if none does. `kept`: the kind of step that is never
    reached, because this call doesn't return. That's another "spin", a line that would "create" an object, or the next
    "round" of a loop. `later` and `later_code`: the number and the code of the line that is never reached. `waits`:
    "rate" or "future" if the line doesn't spin, but waits in vain for a rate or a future, or else "".
    """

    line: int
    code: str
    callback: str = ""
    kept: Literal["", "spin", "create", "round"] = ""
    later: int = 0
    later_code: str = ""
    waits: Literal["", "rate", "future"] = ""
    ignores_unknown_fields: ClassVar[bool] = True


@dataclass(frozen=True)
class ProcessRecord:
    """A record of the program's process.

    `ended_by`: what made it exit ("itself" or "judge"), or None while it's running. `log`: its output until the judge
    sent SIGINT. `end_log`: its output after that. `processor`: on the wall clock, pairs of a wall time (s) and the CPU
    time (s) that the program had used by that time. `printed_at`: the wall time (s) at which the last output in `log`
    arrived. `driver_key`: the key, in hexadecimal, with which a driver signed its reports. It's empty if there was no
    driver, and in old recordings. `unfiltered`: a clause that says why the isolation tier couldn't filter system calls.
    It's empty if they were filtered, or if the tier doesn't filter any.
    """

    program: str = ""
    exit: int | None = None
    signal: str | None = None
    ended_at: float | None = None
    ended_by: Literal["itself", "judge"] | None = None
    watched_for: float = 0.0
    limits_hit: tuple[str, ...] = field(default=(), metadata=ALWAYS_STORED)
    log: str = ""
    end_log: str = ""
    log_truncated: bool = False
    domains_used: tuple[int, ...] = field(default=(), metadata=ALWAYS_STORED)
    processor: tuple[tuple[float, float], ...] = ()
    printed_at: float | None = None
    driver_key: str = ""
    unfiltered: str = field(default="", metadata=STORED_IF_SET)


@dataclass(frozen=True)
class Stretch:
    """A part of the watch with one speed (simulated seconds per real second). `start` and `end`: simulated time (s)."""

    speed: float
    start: float
    end: float


@dataclass(frozen=True)
class Recording:
    """One recorded run of a program: its messages, calls, and services, and the record of its process.

    `watched_s`: the duration of the watch (s) in simulated time, or in real time if the watch used the wall clock.
    `wall_s`: its duration (s) in real time. `stretches`: the intervals with different speeds of simulated time, in
    order.

    `findings`: the type checker's messages, or None if it didn't run. `wanted`: the topics and services that a correct
    program uses. The list is stored so that none of them is mistaken for a misspelling of another. `following`: for
    each topic, True if its messages provably follow the simulated clock, and False if they provably don't. Topics for
    which neither has been proved are absent. `in_lockstep`: whether the program was at rest before each step of the
    simulated clock, so that a slow machine couldn't delay its messages. `own_clock`: nodes that subscribed to /clock on
    their own, before the judge switched the program to simulated time.

    `held_up_s`: for a watch on the wall clock, the longest time (s) that the judge itself had to wait for a processor.
    If the judge runs in a virtual machine, its host can withhold processors. `stood_still_s` is the longest time (s)
    that one of them was withheld. `taken_s` is the total time (s), averaged over the processors. `in_line_s`: the total
    time (s) that the program was ready to run but had to wait for a processor.

    `seed`: the script's seed, or None if the script is the same in each run. `unpublished`: the script's messages that
    were still unpublished when the watch ended. Their `t` and `wall` are the times at which they were due. `spins`: the
    calls in the program's source that spin a node. `repeated_init`: the number (from 1) of a line that calls
    rclpy.init() in a loop, or 0 if there is none.
    """

    format: Literal[1] = field(default=FORMAT, kw_only=True, repr=False, metadata=ALWAYS_STORED)
    clock: Clock
    domain_id: int
    stretches: tuple[Stretch, ...] = field(default=(), metadata={**ALWAYS_STORED, **stored_as("phases")})
    watched_s: float = field(default=0.0, metadata={**ALWAYS_STORED, **stored_as("robot_s")})
    wall_s: float = field(default=0.0, metadata=ALWAYS_STORED)
    topics: Mapping[str, TopicRecording] = field(default_factory=dict, metadata=ALWAYS_STORED)
    nodes: tuple[NodeSeen, ...] = field(default=(), metadata=ALWAYS_STORED)
    process: ProcessRecord = field(default_factory=ProcessRecord, metadata=ALWAYS_STORED)
    follows_clock: bool | None = field(default=None, metadata=ALWAYS_STORED)
    step_s: float | None = field(default=None, metadata=ALWAYS_STORED)
    notes: tuple[str, ...] = field(default=(), metadata=ALWAYS_STORED)
    published: tuple[Published, ...] = field(default=(), metadata=stored_as("said"))
    calls: tuple[CallSeen, ...] = ()
    services: tuple[ServiceSeen, ...] = ()
    findings: tuple[Finding, ...] | None = None
    clients: tuple[ServiceSeen, ...] = ()
    held_up_s: float = 0.0
    stood_still_s: float = 0.0
    taken_s: float = 0.0
    in_line_s: float = 0.0
    wanted: tuple[str, ...] = ()
    following: Mapping[str, bool] = field(default_factory=dict)
    in_lockstep: bool = False
    own_clock: tuple[str, ...] = ()
    seed: int | None = None
    unpublished: tuple[Published, ...] = field(default=(), metadata=stored_as("unsaid"))
    spins: tuple[SpinSeen, ...] = ()
    repeated_init: int = 0
    ignores_unknown_fields: ClassVar[bool] = True

    def topic(self, name: str) -> TopicRecording:
        """Return a topic's recording, which is empty if the topic wasn't seen."""
        return self.topics.get(name, TopicRecording(name))

    def with_publishers(self) -> tuple[TopicRecording, ...]:
        """Return the topics that had a publisher, sorted by name."""
        return tuple(self.topics[name] for name in sorted(self.topics) if self.topics[name].publishers)

    def to_json(self) -> dict[str, Any]:
        """Convert the recording to plain data for `json`. NaN and infinite numbers are stored as strings."""
        data: dict[str, Any] = encode(self)
        return data

    def save(self, path: Path) -> None:
        """Write the recording to a file as JSON, for `load`."""
        path.write_text(json.dumps(self.to_json(), allow_nan=False, separators=(",", ":")))

    @classmethod
    def from_json(cls, data: object) -> "Recording":
        """Rebuild a recording from data that `to_json` returned.

        Raise ValueError if the data isn't a recording or has a different format.
        """
        if not isinstance(data, dict) or data.get("format") != FORMAT:
            found = (
                f"format is {data.get('format')!r}"
                if isinstance(data, dict)
                else f"it is {type(data).__name__}"
            )
            raise ValueError(f"this is not a recording of format {FORMAT}: {found}")
        try:
            return decode(cls, data)
        except Malformed as error:
            raise ValueError(f"this recording is damaged: {error}") from error

    @classmethod
    def load(cls, path: Path) -> "Recording":
        """Load a recording from a file. Raise ValueError if it isn't a recording, and OSError if it can't be read."""
        return cls.from_json(json.loads(path.read_text()))
