"""What the judge sends to a program under watch: messages, services that it offers, services that it calls.

A script is data. Its times are seconds of simulated time since the watch began. Everything here is plain Python, so
that a criteria file can name its parts again when it judges.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from workbook.recording.type_names import type_name

Qos = Literal["reliable", "best_effort", "latched"]
BEFORE_START = -1.0
"""In place of a time (s): published before the program is started."""


@dataclass(frozen=True)
class Line:
    """One message of a script: when (s; `BEFORE_START`: before the program is started), and its fields."""

    at: float
    value: Mapping[str, Any]


@dataclass(frozen=True)
class Publishes:
    """Messages that the judge publishes on a topic. "latched": reliable, and the last one is kept for late joiners.

    `deadline`: the longest time (s) from one message to the next that the publisher offers; None offers none.
    `awaited`: whether the watch begins only when the program listens.
    """

    topic: str
    type: str
    lines: tuple[Line, ...]
    qos: Qos = "reliable"
    depth: int = 100
    deadline: float | None = None
    awaited: bool = True


@dataclass(frozen=True)
class Reply:
    """How one call is answered: the fields of the response, after how many seconds; None: never."""

    value: Mapping[str, Any]
    after: float | None = 0.0


@dataclass(frozen=True)
class Serves:
    """A service that the judge offers. The first call gets the first reply, and so on; then the last one again."""

    service: str
    type: str
    replies: tuple[Reply, ...]


@dataclass(frozen=True)
class Calls:
    """Calls that the judge makes to a service of the program."""

    service: str
    type: str
    lines: tuple[Line, ...]


Part = Publishes | Serves | Calls


@dataclass(frozen=True)
class Script:
    """All that the judge sends in one watch."""

    parts: tuple[Part, ...] = field(default=())

    def __bool__(self) -> bool:
        return bool(self.parts)

    @property
    def names(self) -> tuple[str, ...]:
        """Topics and services that a program needs for it; not those that it should leave alone."""
        publish = [part.topic for part in self.parts if isinstance(part, Publishes) and part.awaited]
        return *publish, *(part.service for part in self.parts if not isinstance(part, Publishes))

    @property
    def last_at(self) -> float:
        """When the last line is due (s)."""
        lines = [line.at for part in self.parts if not isinstance(part, Serves) for line in part.lines]
        return max(lines, default=0.0)


NOTHING_SAID = Script()


def publish(
    topic: str,
    message_class: Any,
    lines: Sequence[tuple[float, Any]],
    qos: Qos = "reliable",
    depth: int = 100,
    deadline: float | None = None,
    awaited: bool = True,
) -> Publishes:
    """Messages for `topic` as pairs of a time (s) and a value: the fields, or only that of `data`.

    The watch begins when the program listens to `topic`. With `awaited=False` it does not wait for that: for a topic
    that a program should leave alone.

    A subscription that requests a deadline is matched only where one as short is offered: offer it with `deadline`
    (s). Raises ValueError for a deadline that is not above zero.
    """
    if deadline is not None and not deadline > 0.0:
        raise ValueError(f"a deadline is above zero, not {deadline}")
    return Publishes(topic, type_name(message_class), _lines(lines), qos, depth, deadline, awaited)


def serves(
    service: str, service_class: Any, replies: Sequence[tuple[Mapping[str, Any], float | None]]
) -> Serves:
    """A service for the program to call; `replies` as pairs of the response's fields and the seconds it takes."""
    if not replies:
        raise ValueError(f"{service} needs at least one reply")
    return Serves(service, type_name(service_class), tuple(Reply(value, after) for value, after in replies))


def calls(service: str, service_class: Any, lines: Sequence[tuple[float, Mapping[str, Any]]]) -> Calls:
    """Calls to a service of the program, as pairs of a time (s) and the fields of the request."""
    return Calls(service, type_name(service_class), _lines(lines))


def _lines(pairs: Sequence[tuple[float, Any]]) -> tuple[Line, ...]:
    """In order, and to the microsecond: what a sum of floats has too much would delay a line by a step of the clock."""
    lines = [
        Line(round(at, 6), value if isinstance(value, Mapping) else {"data": value}) for at, value in pairs
    ]
    return tuple(sorted(lines, key=lambda line: line.at))
