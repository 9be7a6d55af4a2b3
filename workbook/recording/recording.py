"""Define the recording of a program's run: which nodes published which messages when, and what the process did.

A recording is plain data, made once and stored as JSON. Everything else (figures, criteria, feedback) is derived from
it. Times named `t` are simulated time (s) since the watch began. Times named `wall` are real time (s) since the program
was started.
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

    `t` and `wall` are its arrival times. `sent` is the wall time (s) at which the program published it, from the time
    stamp that DDS adds to every message. It's None in old recordings.
    """

    t: float
    wall: float
    value: Any
    sent: float | None = None
    ignores_unknown_fields: ClassVar[bool] = True

    @property
    def published(self) -> float:
        """When the program published the message (wall time in seconds), or when the message arrived if that's unknown.

        DDS sends a lost message again, so messages on two topics may arrive in a different order than they were
        published. So compare these times to find out which message came first, or which message caused another.
        """
        return self.wall if self.sent is None else self.sent


@dataclass(frozen=True)
class PublisherSeen:
    """A publisher in the graph: its node's fully qualified name, its type, its QoS, and when the judge saw it.

    `deadline` and `lifespan` are in seconds, or None if there is no such limit. `last_seen` is None if the publisher
    stayed.
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
    """The recording of one topic. `window` is the start and end (s) of its watch, which begins when it's matched.

    `undecodable`: the number of messages whose bytes don't fit the type. `not_kept`: the number of messages that
    arrived but aren't stored; `too_large` of them exceeded the size limit. `broken_at`: when (simulated time, s) the
    first undecodable or too large message arrived. `full_at`: when this topic's quota was used up; None if it never
    was. `room`: the quota in bytes if the topic ran out of bytes; None if it ran out of messages. `kept`: how many
    earlier messages a late subscription received. It's None if there was no such subscription, or if new messages
    arrived in the meantime.
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
        """The message types of the topic's publishers, sorted, each once."""
        return tuple(sorted({publisher.type for publisher in self.publishers}))


@dataclass(frozen=True)
class NodeSeen:
    """A node in the graph: its fully qualified name, and when (wall time, s) it appeared.

    `most`: the largest number of nodes with this name at the same time. `stayed`: whether it was still in the graph
    after the program's end; None if the end wasn't watched.
    """

    name: str
    first_seen: float
    most: int = 1
    stayed: bool | None = None


@dataclass(frozen=True)
class Published:
    """One message of the script, as the judge published it. `value` contains its fields as plain data, as in `Arrival`.

    `t` and `wall`: simulated and wall time (s) just before the judge published it.
    """

    topic: str
    t: float
    wall: float
    value: Any
    ignores_unknown_fields: ClassVar[bool] = True


@dataclass(frozen=True)
class CallSeen:
    """One service call. `by`: "program" for the program's call to the judge's service, "judge" for a call by the judge.

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
    """The fully qualified name and type of a service that the program offers or has a client for."""

    name: str
    type: str


SILENCED, UNCHECKED, UNFINISHED = "silenced", "unchecked", "unfinished"
"""Codes of findings that we add: code that silences mypy, code that mypy skips, and a mypy run that didn't finish."""


@dataclass(frozen=True)
class Finding:
    """One message from the type checker about the program or a probe, which is code that uses the program.

    `probe`: the probe's name; "" for the program. `line` counts from 1; it's 0 if the finding isn't about a line.
    """

    probe: str
    line: int
    code: str
    message: str


@dataclass(frozen=True)
class SpinSeen:
    """A source line that spins and may be why nothing is published: `code` at `line` (from 1).

    `callback`: the callback that runs this line; empty if none does. `kept`: the step that is never reached, because
    this call doesn't return. That's another "spin", a line that would "create" an object, or the next "round" of a
    loop. `later` and `later_code`: the number and code of the line that is never reached. `waits`: if the line doesn't
    spin, but waits in vain, "rate" or "future".
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
    """How the program ran and ended. `ended_by` is "itself", "judge", or None while it runs.

    `log` is its output up to the judge's Ctrl-C, `end_log` its output after that. `processor`: on the wall clock, pairs
    of a wall time (s) and the CPU time (s) that the program had used by that time. `printed_at`: when the last text of
    `log` arrived (wall time, s). `driver_key`: the key with which a driver signed its reports, in hexadecimal. It's
    empty if there was no driver, and in old recordings. `unfiltered`: a clause that says why the sandbox tier couldn't
    filter system calls. It's empty if they were filtered, or if the tier doesn't filter any.
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
    """One recorded run of a program: what it published, received, and called, and how its process ran and ended.

    `watched_s`: how long (s) the watch lasted: in simulated time, or in real time if the watch used the wall clock.
    `wall_s`: how long (s) the watch took in real time. `stretches`: the intervals of simulated time, in order.

    `findings`: the type checker's messages; None if it didn't run. `wanted`: the topics and services that a correct
    program uses, so that none of them is mistaken for a misspelling of another. `following`: for each topic, True if
    its messages provably follow the simulated clock, and False if they provably don't. Topics for which neither is
    proved are absent. `in_lockstep`: whether the program was at rest before each step of the simulated clock, so that a
    slow machine couldn't delay its messages. `own_clock`: nodes that subscribed to /clock on their own, before the
    judge switched the program to simulated time.

    `held_up_s`: for a watch on the wall clock, the longest time (s) that the judge itself had to wait for a processor.
    `stood_still_s`: the longest time (s) that one of this virtual machine's processors was unavailable because of the
    host. `taken_s`: the total time (s) that processors were unavailable because of the host, averaged over the
    processors. `in_line_s`: the total time (s) that the program was ready to run but had to wait for a processor.

    `seed`: the script's seed; None if the script is the same in each run. `unpublished`: the script's messages that
    were still unpublished when the watch ended. Their `t` and `wall` are the times at which they were due. `spins`: the
    calls that spin a node, as found in the program's source. `repeated_init`: the number of a line (the first line is
    1) that calls rclpy.init() in a loop; 0 if there is none.
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
        """Convert the recording to plain data for `json`. NaN and infinite numbers are stored as text."""
        data: dict[str, Any] = encode(self)
        return data

    def save(self, path: Path) -> None:
        """Write the recording to a file as JSON, for `load`."""
        path.write_text(json.dumps(self.to_json(), allow_nan=False, separators=(",", ":")))

    @classmethod
    def from_json(cls, data: object) -> "Recording":
        """Rebuild a recording from the data of `to_json`.

        Raise ValueError if the data isn't a recording, or has a different format.
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
