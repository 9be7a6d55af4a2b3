"""Define the judge's script for a watched program: messages to publish, services to offer, and services to call.

A script is plain data, so an exercise's criteria can refer to its parts. The script's times are simulated times (s)
since the watch began. (In a watch, the judge runs a program and records its effects.)
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal

from workbook.recording.type_names import type_name

Qos = Literal["reliable", "best_effort", "latched"]
BEFORE_START = -1.0
"""A special value for a line's time: the judge publishes the line before it starts the program."""


@dataclass(frozen=True)
class Line:
    """One message or request of a script: the time `at` which it's due (s, or `BEFORE_START`), and its fields."""

    at: float
    value: Mapping[str, Any]


@dataclass(frozen=True)
class Publishes:
    """Messages that the judge publishes on a topic.

    `qos`: "latched" means that the publisher is reliable and keeps the latest message for late joiners. `deadline`: the
    deadline (s) that the publisher offers, or None. `awaited`: whether the watch begins only after the program has
    subscribed.
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
    """The response to one call: its fields, and its delay `after` (s), or None if the judge never responds."""

    value: Mapping[str, Any]
    after: float | None = 0.0


@dataclass(frozen=True)
class Serves:
    """A service that the judge offers.

    Each call gets the next reply. After the last reply, every call gets that one.
    """

    service: str
    type: str
    replies: tuple[Reply, ...]


@dataclass(frozen=True)
class Calls:
    """Calls that the judge makes to one of the program's services."""

    service: str
    type: str
    lines: tuple[Line, ...]


Part = Publishes | Serves | Calls


@dataclass(frozen=True)
class Script:
    """Everything that the judge sends in one watch."""

    parts: tuple[Part, ...] = field(default=())

    def __bool__(self) -> bool:
        return bool(self.parts)

    @property
    def names(self) -> tuple[str, ...]:
        """The topics and services that a correct program uses. Topics that it shouldn't use are left out."""
        publish = [part.topic for part in self.parts if isinstance(part, Publishes) and part.awaited]
        return *publish, *(part.service for part in self.parts if not isinstance(part, Publishes))


EMPTY_SCRIPT = Script()


def publish(
    topic: str,
    message_class: Any,
    lines: Sequence[tuple[float, Any]],
    qos: Qos = "reliable",
    depth: int = 100,
    deadline: float | None = None,
    awaited: bool = True,
) -> Publishes:
    """Define messages for `topic`.

    `lines` are pairs of a time (s) and a value: a mapping of the message's fields, or only the value of its field
    `data`.

    The watch begins when the program subscribes to `topic`. For a topic that the program shouldn't use, pass
    `awaited=False`, so that the watch doesn't wait for a subscription.

    A subscription that requests a deadline matches only a publisher that offers the same deadline or a shorter one. For
    such a subscription, set `deadline` (s). Raise ValueError if the deadline isn't above zero.
    """
    if deadline is not None and not deadline > 0.0:
        raise ValueError(f"a deadline is above zero, not {deadline}")
    return Publishes(topic, type_name(message_class), _lines(lines), qos, depth, deadline, awaited)


def serves(
    service: str, service_class: Any, replies: Sequence[tuple[Mapping[str, Any], float | None]]
) -> Serves:
    """Define a service for the program to call.

    `replies` are pairs of a response's fields and its delay (s), or None instead of the delay if the judge never
    responds. Raise ValueError if there are no replies.
    """
    if not replies:
        raise ValueError(f"{service} needs at least one reply")
    return Serves(service, type_name(service_class), tuple(Reply(value, after) for value, after in replies))


def calls(service: str, service_class: Any, lines: Sequence[tuple[float, Mapping[str, Any]]]) -> Calls:
    """Define calls to one of the program's services. `lines` are pairs of a time (s) and the request's fields."""
    return Calls(service, type_name(service_class), _lines(lines))


def _lines(pairs: Sequence[tuple[float, Any]]) -> tuple[Line, ...]:
    """Return the lines sorted by time, with each time rounded to microseconds.

    Without the rounding, a float's rounding error could delay a line by one clock step.
    """
    lines = [
        Line(round(at, 6), value if isinstance(value, Mapping) else {"data": value}) for at, value in pairs
    ]
    return tuple(sorted(lines, key=lambda line: line.at))
