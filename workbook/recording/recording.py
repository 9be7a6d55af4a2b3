"""What was seen of a program: who published what, when and how, and what the process did.

A recording is plain data. It is made once, stored as JSON, and everything else (pictures, criteria, feedback)
is a function of it. Times named `t` are simulated time in seconds since the watch began; `wall` is real time in
seconds since the program was started.
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
    """One message as it arrived. `value` holds its fields as plain data, e.g. `{"data": 99.5}`.

    `t` and `wall` tell when it arrived. `sent` is the wall time (s) at which the program published it, from the time
    stamp that DDS puts on every message; None in old recordings.
    """

    t: float
    wall: float
    value: Any
    sent: float | None = None
    ignores_unknown_fields: ClassVar[bool] = True

    @property
    def published(self) -> float:
        """When the program published it (s of wall time).

        A message that gets lost on its way is sent once more, so messages of two topics may arrive in another order
        than they were published. To tell what came first, or what came from what, compare these.
        """
        return self.wall if self.sent is None else self.sent


@dataclass(frozen=True)
class PublisherSeen:
    """A publisher on the graph: full node name, message type and the QoS it offers (`deadline`, `lifespan` in s)."""

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
    """A subscription on the graph: full node name, message type and the QoS that it requests (`deadline` in s)."""

    node: str
    type: str
    reliability: str
    durability: str
    deadline: float | None = None


@dataclass(frozen=True)
class TopicRecording:
    """Everything about one topic; `window` is the simulated time from its match to the end of the watch.

    `undecodable`: messages whose bytes are none of its type. `not_kept`: messages that came and are not here;
    `too_large` of them were larger than a message may be. `broken_at`: when (s of simulated time) the first came that
    was undecodable or too large. `full_at`: when the room for this topic was used up; None if it never was. `room`: how
    many bytes that is; None where there were too many messages. `kept`: how many earlier messages a subscription got
    that was made after the watch; None where none was made, or where new messages came meanwhile.
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
        """The message types of its publishers, sorted, each once."""
        return tuple(sorted({publisher.type for publisher in self.publishers}))


@dataclass(frozen=True)
class NodeSeen:
    """A node on the graph by its full name, and when (wall time, s) it appeared.

    `most`: how many nodes of this name there were at once. `stayed`: still on the graph after the program had ended
    (None where the end was not watched).
    """

    name: str
    first_seen: float
    most: int = 1
    stayed: bool | None = None


@dataclass(frozen=True)
class Published:
    """One message of the script, as the judge published it. `value` holds its fields as plain data, as in `Arrival`.

    `t`: simulated time (s). `wall`: wall time (s), just before it was published.
    """

    topic: str
    t: float
    wall: float
    value: Any
    ignores_unknown_fields: ClassVar[bool] = True


@dataclass(frozen=True)
class CallSeen:
    """One call of a service. `by`: "program" for a call to the judge's service, "judge" for a call by the judge.

    `response` and the moments of the answer are None when there was none.
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
    """A service that the program offers, or has a client for, by its full name and type."""

    name: str
    type: str


SILENCED, UNCHECKED, UNFINISHED = "silenced", "unchecked", "unfinished"
"""Codes of findings that are not mypy's own: what keeps it from reporting, from checking, and from finishing."""


@dataclass(frozen=True)
class Finding:
    """One thing that the type checker said of the program, or of a `probe`: code that uses it ("" for the program).

    `line` counts from 1; it is 0 where no line is to blame.
    """

    probe: str
    line: int
    code: str
    message: str


@dataclass(frozen=True)
class SpinSeen:
    """A line of the source that spins, and that may be why nothing is published: `code` at `line` (from 1).

    `callback`: the callback that it is called from; empty where there is none. `kept`: what cannot begin because this
    call does not return: another "spin", something that a later line would "create", or the next "round" of a loop.
    `later`, `later_code`: where that stands. `waits`: this line does not spin, but waits in vain for a "rate"
    or for a "future".
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
    """How the program ran and ended. `ended_by` is "itself", "judge" (the judge), or None while it runs.

    `log` is what it printed of its own accord, `end_log` what it printed after the judge had sent Ctrl-C.
    `processor`: on the wall clock, pairs of wall time (s) and processor time (s) that it had used by then.
    `printed_at`: when the last text of `log` came (wall time, s). `driver_key`: what a driver has signed its reports
    with, in hexadecimal digits; empty where there was none, and in old recordings. `unfiltered`: why its tier could not
    filter its system calls, as a clause; empty where they were filtered, and where the tier filters none.
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
class Phase:
    """A stretch of the watch at one speed (robot seconds per real second); `start` and `end` in simulated time."""

    speed: float
    start: float
    end: float


@dataclass(frozen=True)
class Recording:
    """One observed run of one program: what it published, heard and called, and how its process ran and ended.

    `findings`: what the type checker said; None if it was not asked. `wanted`: topics and services that a right program
    has, so that none of them is taken for a misspelled other one. `following`: by topic, whether its messages were
    proved to follow the simulated clock; a topic of which nothing is proved is not in it. `in_lockstep`: whether the
    program was at rest before each step of that clock, so that nothing it did in real time could make it late.
    `own_clock`: nodes that subscribed to /clock by themselves, before anything was switched to simulated time.

    `held_up_s`: on the wall clock, the longest time (s) for which the watch itself got no processor; `stood_still_s`:
    the longest for which the host of this virtual machine took a processor away; `taken_s`: how long (s) it did so in
    all, the mean of all processors; `in_line_s`: how long (s) in all the program was ready to run and got none.

    `seed`: what the script was drawn from; None where it is the same in each run. `unpublished`: the messages of the
    script that were still to come when the watch ended (`t` and `wall`: when they were due). `spins`: what the source
    of the program says about its spins. `repeated_init`: the line (from 1) of an rclpy.init() in a loop; 0 if there is
    none.
    """

    format: Literal[1] = field(default=FORMAT, kw_only=True, repr=False, metadata=ALWAYS_STORED)
    clock: Clock
    domain_id: int
    phases: tuple[Phase, ...] = field(default=(), metadata=ALWAYS_STORED)
    simulated_s: float = field(default=0.0, metadata={**ALWAYS_STORED, **stored_as("robot_s")})
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
        """The recording of a topic; an empty one if nothing of that name was seen."""
        return self.topics.get(name, TopicRecording(name))

    def with_publishers(self) -> tuple[TopicRecording, ...]:
        """Topics that had a publisher, by name."""
        return tuple(self.topics[name] for name in sorted(self.topics) if self.topics[name].publishers)

    def to_json(self) -> dict[str, Any]:
        """Plain data that `json` can write: no NaN (spelled as text), no tuples needed."""
        data: dict[str, Any] = encode(self)
        return data

    def save(self, path: Path) -> None:
        """Write the recording to a file, as JSON that `load` reads."""
        path.write_text(json.dumps(self.to_json(), allow_nan=False, separators=(",", ":")))

    @classmethod
    def from_json(cls, data: object) -> "Recording":
        """Rebuild a recording. Raises ValueError when the data is not one or is of another format."""
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
        """Read a recording from a file. Raises ValueError when it is not one, OSError when it cannot be read."""
        return cls.from_json(json.loads(path.read_text()))
