"""What was seen of a program: who published what, when and how, and what the process did.

A recording is plain data. It is made once, stored as JSON, and everything else (pictures, criteria, feedback)
is a function of it. Times named `t` are robot time in seconds since the watch began; `wall` is real time in
seconds since the program was started.
"""

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

FORMAT = 1

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

    @property
    def published(self) -> float:
        """When the program published it (s of wall time).

        A message that gets lost on its way is sent once more, so messages of two topics may arrive in another order
        than they were published. To tell what came first, or what came from what, compare these.
        """
        return self.wall if self.sent is None else self.sent


@dataclass(frozen=True)
class PublisherSeen:
    """A publisher on the graph: full node name, message type and the QoS that it offers (`deadline` in s)."""

    node: str
    type: str
    reliability: str
    durability: str
    first_seen: float
    last_seen: float | None = None
    deadline: float | None = None


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
    """Everything about one topic; `window` is the robot time from its match to the end of the watch."""

    name: str
    publishers: tuple[PublisherSeen, ...] = ()
    subscribers: tuple[SubscriberSeen, ...] = ()
    arrivals: tuple[Arrival, ...] = ()
    window: tuple[float, float] | None = None
    undecodable: int = 0
    not_kept: int = 0

    @property
    def types(self) -> tuple[str, ...]:
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
class Said:
    """One message that the bench published, as its script wanted it."""

    topic: str
    t: float
    wall: float
    value: Any


@dataclass(frozen=True)
class CallSeen:
    """One call of a service: made `by` the program to the bench's service, or by the bench to the program's.

    `response` and the moments of the answer are None when there was none.
    """

    service: str
    by: Literal["program", "bench"]
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
class ProcessRecord:
    """How the program ran and ended. `ended_by` is "itself", "bench", or None while it runs.

    `log` is what it printed of its own accord, `end_log` what it printed after the bench had sent Ctrl-C.
    `processor`: on the wall clock, pairs of wall time (s) and processor time (s) that it had used by then.
    """

    program: str = ""
    exit: int | None = None
    signal: str | None = None
    ended_at: float | None = None
    ended_by: Literal["itself", "bench"] | None = None
    watched_for: float = 0.0
    limits_hit: tuple[str, ...] = ()
    log: str = ""
    end_log: str = ""
    log_truncated: bool = False
    domains_used: tuple[int, ...] = ()
    processor: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True)
class Phase:
    """A stretch of the watch at one speed (robot seconds per real second); `start` and `end` in robot time."""

    speed: float
    start: float
    end: float


@dataclass(frozen=True)
class Recording:
    """One watch of one program. `findings`: what the type checker said; None if it was not asked. `wanted`: topics and
    services that a right program has, so that none of them is taken for a misspelled other one.

    `held_up_s`: on the wall clock, the longest time (s) for which the watch itself got no processor; `stood_still_s`:
    the longest for which the host of this virtual machine took a processor away; `taken_s`: how long (s) it did so in
    all, the mean of all processors; `in_line_s`: how long (s) in all the program was ready to run and got none.
    """

    clock: Clock
    domain_id: int
    phases: tuple[Phase, ...] = ()
    robot_s: float = 0.0
    wall_s: float = 0.0
    topics: Mapping[str, TopicRecording] = field(default_factory=dict)
    nodes: tuple[NodeSeen, ...] = ()
    process: ProcessRecord = field(default_factory=ProcessRecord)
    follows_clock: bool | None = None
    step_s: float | None = None
    notes: tuple[str, ...] = ()
    said: tuple[Said, ...] = ()
    calls: tuple[CallSeen, ...] = ()
    services: tuple[ServiceSeen, ...] = ()
    findings: tuple[Finding, ...] | None = None
    clients: tuple[ServiceSeen, ...] = ()
    held_up_s: float = 0.0
    stood_still_s: float = 0.0
    taken_s: float = 0.0
    in_line_s: float = 0.0
    wanted: tuple[str, ...] = ()

    def topic(self, name: str) -> TopicRecording:
        """The recording of a topic; an empty one if nothing of that name was seen."""
        return self.topics.get(name, TopicRecording(name))

    def published(self) -> tuple[TopicRecording, ...]:
        """Topics that had a publisher, by name."""
        return tuple(self.topics[name] for name in sorted(self.topics) if self.topics[name].publishers)

    def to_json(self) -> dict[str, Any]:
        """Plain data that `json` can write: no NaN (spelled as text), no tuples needed."""
        return {"format": FORMAT, **_encode(self)}

    def save(self, path: Path) -> None:
        path.write_text(json.dumps(self.to_json(), allow_nan=False, separators=(",", ":")))

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> "Recording":
        """Rebuild a recording. Raises ValueError when the data is not one or is of another format."""
        if not isinstance(data, Mapping) or data.get("format") != FORMAT:
            found = (
                f"format is {data.get('format')!r}"
                if isinstance(data, Mapping)
                else f"it is {type(data).__name__}"
            )
            raise ValueError(f"this is not a recording of format {FORMAT}: {found}")
        try:
            return _recording(data)
        except (LookupError, TypeError, AttributeError) as error:
            raise ValueError(f"this recording is damaged: {error!r}") from error

    @classmethod
    def load(cls, path: Path) -> "Recording":
        """Read a recording from a file. Raises ValueError when it is not one, OSError when it cannot be read."""
        return cls.from_json(json.loads(path.read_text()))


_SPECIAL = {"nan": math.nan, "inf": math.inf, "-inf": -math.inf}


def _encode(value: Any) -> Any:
    if isinstance(value, float) and not math.isfinite(value):
        return {"float": str(value)}
    if isinstance(value, (str, int, float, bool)) or value is None:
        return value
    if isinstance(value, Mapping):
        return {str(key): _encode(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_encode(item) for item in value]
    return {name: _encode(getattr(value, name)) for name in value.__dataclass_fields__}


def _decode(value: Any) -> Any:
    if isinstance(value, dict):
        if set(value) == {"float"} and value["float"] in _SPECIAL:
            return _SPECIAL[value["float"]]
        return {key: _decode(item) for key, item in value.items()}
    if isinstance(value, list):
        return [_decode(item) for item in value]
    return value


def _topic(data: Mapping[str, Any]) -> TopicRecording:
    window = data["window"]
    return TopicRecording(
        name=data["name"],
        publishers=tuple(PublisherSeen(**item) for item in data["publishers"]),
        subscribers=tuple(SubscriberSeen(**item) for item in data["subscribers"]),
        arrivals=tuple(
            Arrival(item["t"], item["wall"], _decode(item["value"]), item.get("sent"))
            for item in data["arrivals"]
        ),
        window=None if window is None else (window[0], window[1]),
        undecodable=data["undecodable"],
        not_kept=data["not_kept"],
    )


def _findings(data: Any) -> tuple[Finding, ...] | None:
    return None if data is None else tuple(Finding(**item) for item in data)


def _recording(data: Mapping[str, Any]) -> Recording:
    process = dict(data["process"])
    process["limits_hit"] = tuple(process["limits_hit"])
    process["domains_used"] = tuple(process["domains_used"])
    process["processor"] = tuple((wall, used) for wall, used in process.get("processor", ()))
    return Recording(
        clock=data["clock"],
        domain_id=data["domain_id"],
        phases=tuple(Phase(**item) for item in data["phases"]),
        robot_s=data["robot_s"],
        wall_s=data["wall_s"],
        topics={name: _topic(item) for name, item in data["topics"].items()},
        nodes=tuple(NodeSeen(**item) for item in data["nodes"]),
        process=ProcessRecord(**process),
        follows_clock=data["follows_clock"],
        step_s=data["step_s"],
        notes=tuple(data["notes"]),
        said=tuple(
            Said(item["topic"], item["t"], item["wall"], _decode(item["value"]))
            for item in data.get("said", ())
        ),
        calls=tuple(
            CallSeen(**{**item, "request": _decode(item["request"]), "response": _decode(item["response"])})
            for item in data.get("calls", ())
        ),
        services=tuple(ServiceSeen(**item) for item in data.get("services", ())),
        findings=_findings(data.get("findings")),
        clients=tuple(ServiceSeen(**item) for item in data.get("clients", ())),
        held_up_s=data.get("held_up_s", 0.0),
        stood_still_s=data.get("stood_still_s", 0.0),
        taken_s=data.get("taken_s", 0.0),
        in_line_s=data.get("in_line_s", 0.0),
        wanted=tuple(data.get("wanted", ())),
    )
