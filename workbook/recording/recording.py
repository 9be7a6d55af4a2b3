"""Store a program's run: which nodes published which messages when, and what the process did.

A recording is plain data, made once and stored as JSON. Everything else (figures, criteria, feedback) is derived from
it. Times named `t` are simulated time (s) since the watch began. `wall` is real time (s) since the program was started.
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
        """When the program published the message (s of wall time).

        DDS sends a lost message again, so messages on two topics may arrive in a different order than they were
        published. Compare these times to find the first message or a message's cause.
        """
        return self.wall if self.sent is None else self.sent


@dataclass(frozen=True)
class PublisherSeen:
    """A publisher on the graph: its node's fully qualified name, type, and QoS (`deadline`, `lifespan` in s)."""

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
    """A subscription on the graph: its node's fully qualified name, type, and QoS (`deadline` in s)."""

    node: str
    type: str
    reliability: str
    durability: str
    deadline: float | None = None


@dataclass(frozen=True)
class TopicRecording:
    """The recording of one topic. `window` is the simulated time from its match to the end of the watch.

    `undecodable`: messages whose bytes don't fit the type. `not_kept`: messages that arrived but aren't stored;
    `too_large` of them exceeded the size limit. `broken_at`: when (s of simulated time) the first undecodable or too
    large message arrived. `full_at`: when this topic's quota was used up; None if it never was. `room`: the quota in
    bytes if bytes ran out; None if the number of messages did. `kept`: how many earlier messages a late subscription
    received. It is None without such a subscription, or if new messages arrived in the meantime.
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
    """A node on the graph: its fully qualified name, and when (wall time, s) it appeared.

    `most`: the largest number of nodes with this name at the same time. `stayed`: whether it was still on the graph
    after the program's end; None if the end wasn't watched.
    """

    name: str
    first_seen: float
    most: int = 1
    stayed: bool | None = None


@dataclass(frozen=True)
class Published:
    """One message of the script, as the judge published it. `value` contains its fields as plain data, as in `Arrival`.

    `t`: simulated time (s). `wall`: wall time (s), just before it was published.
    """

    topic: str
    t: float
    wall: float
    value: Any
    ignores_unknown_fields: ClassVar[bool] = True


@dataclass(frozen=True)
class CallSeen:
    """One service call. `by`: "program" for a call to the judge's service, "judge" for a call by the judge.

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
"""Codes of findings that aren't mypy's: code that silences mypy, code that mypy skips, and a run that didn't finish."""


@dataclass(frozen=True)
class Finding:
    """One message of the type checker about the program, or about a `probe`: code that uses it ("" for the program).

    `line` counts from 1; it's 0 if the finding isn't about a line.
    """

    probe: str
    line: int
    code: str
    message: str


@dataclass(frozen=True)
class SpinSeen:
    """A source line that spins and may be why nothing is published: `code` at `line` (from 1).

    `callback`: the callback that calls it; empty if none does. `kept`: what can't begin because this call doesn't
    return. It's another "spin", an object that a later line would "create", or the next "round" of a loop. `later` and
    `later_code`: that line's number and code. `waits`: the line doesn't spin, but waits in vain for a "rate" or a
    "future".
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
    of wall time (s) and the CPU time (s) used until then. `printed_at`: when the last text of `log` arrived (wall time,
    s). `driver_key`: the key with which a driver signed its reports, in hexadecimal; empty without a driver and in old
    recordings. `unfiltered`: why its tier couldn't filter system calls, as a clause; empty if they were filtered or if
    the tier doesn't filter any.
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
    """A stretch of the watch at one speed (robot seconds per real second). `start` and `end` are simulated time (s)."""

    speed: float
    start: float
    end: float


@dataclass(frozen=True)
class Recording:
    """One recorded run of a program: what it published, received, and called, and how its process ran and ended.

    `watched_s`: how long (s) the watch lasted, in simulated time or, on the wall clock, in real time. `wall_s`: how
    long (s) it took in real time. `stretches`: the stretches of simulated time, in order.

    `findings`: the type checker's messages; None if it didn't run. `wanted`: topics and services of a correct program,
    so that none of them is mistaken for a misspelling of another. `following`: by topic, whether its messages follow
    the simulated clock; topics without proof are missing. `in_lockstep`: whether the program was at rest before each
    step of that clock, so that real time couldn't make it late. `own_clock`: nodes that subscribed to /clock by
    themselves, before the switch to simulated time.

    `held_up_s`: on the wall clock, the longest time (s) for which the watch itself got no processor. `stood_still_s`:
    the longest time (s) for which this virtual machine's host took a processor away. `taken_s`: the total time (s) for
    which the host did so, averaged over the processors. `in_line_s`: the total time (s) for which the program was ready
    to run but got no processor.

    `seed`: the script's seed; None if the script is the same in each run. `unpublished`: the script's messages that
    hadn't been published when the watch ended (`t` and `wall`: when they were due). `spins`: the spins found in the
    program's source. `repeated_init`: the line (from 1) of an rclpy.init() in a loop; 0 if there is none.
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
        """Return a topic's recording; it's empty if the topic wasn't seen."""
        return self.topics.get(name, TopicRecording(name))

    def with_publishers(self) -> tuple[TopicRecording, ...]:
        """Return the topics that had a publisher, sorted by name."""
        return tuple(self.topics[name] for name in sorted(self.topics) if self.topics[name].publishers)

    def to_json(self) -> dict[str, Any]:
        """Convert the recording to plain data for `json`. NaN is stored as text."""
        data: dict[str, Any] = encode(self)
        return data

    def save(self, path: Path) -> None:
        """Write the recording to a file as JSON, for `load`."""
        path.write_text(json.dumps(self.to_json(), allow_nan=False, separators=(",", ":")))

    @classmethod
    def from_json(cls, data: object) -> "Recording":
        """Rebuild a recording. Raise ValueError if the data isn't a recording or has another format."""
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
