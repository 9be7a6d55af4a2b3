"""Play a script to a program: publish messages, respond to calls, and call services, all without an executor.

A *script* contains the judge's messages and calls during a watch. Its *parts* are topics or services, and their *lines*
are messages or calls with times.
"""

import math
import time
from array import array
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from rclpy.serialization import serialize_message

from workbook.recording.recording import CallSeen, Published
from workbook.recording.script import BEFORE_START, Calls, Line, Publishes, Script, Serves
from workbook.ros.messages import message_class, service_class
from workbook.watching.values import plain

SERVED_EVERY_S = 0.01
LATE_S = 0.02
CALLS_KEPT = 2_000
"""After this many calls, further calls are neither answered nor recorded, because a program may call endlessly."""


def fill(message: Any, value: Mapping[str, Any]) -> Any:
    """Set a message's fields from plain data, and nested messages from nested mappings. Return the message.

    `bytes` values are converted to `array`, because with field checks on, a message checks any other type byte by byte.
    """
    for name, item in value.items():
        if isinstance(item, Mapping):
            fill(getattr(message, name), item)
        else:
            setattr(message, name, array("B", item) if isinstance(item, bytes) else item)
    return message


def _qos(part: Publishes) -> QoSProfile:
    best_effort = part.qos == "best_effort"
    latched = part.qos == "latched"
    deadline = {} if part.deadline is None else {"deadline": Duration(seconds=part.deadline)}
    return QoSProfile(
        **deadline,
        history=HistoryPolicy.KEEP_LAST,
        depth=1 if latched else part.depth,
        reliability=ReliabilityPolicy.BEST_EFFORT if best_effort else ReliabilityPolicy.RELIABLE,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if latched else DurabilityPolicy.VOLATILE,
    )


@dataclass
class _Delay:
    """The delay (s) of a script's lines. All parts of the script share one `_Delay`, so that they stay in sync."""

    late_s: float = 0.0


@dataclass
class _Due:
    """The remaining lines of one part of a script."""

    lines: list[Line]
    delay: _Delay

    def next_at(self) -> float:
        return self.lines[0].at + self.delay.late_s if self.lines else math.inf

    def take(self, t: float) -> list[Line]:
        now = [line for line in self.lines if line.at + self.delay.late_s <= t]
        self.lines = self.lines[len(now) :]
        return now

    def take_apart(self, t: float) -> list[Line]:
        """Take the lines that are planned for the next time in the script, if that time has come.

        If these lines are late by more than `LATE_S`, delay all later lines by as much, so that the pauses stay the
        same.
        """
        if self.next_at() > t:
            return []
        if t - self.next_at() > LATE_S:
            self.delay.late_s = t - self.lines[0].at
        return self.take(self.next_at())


class ScriptPlayer:
    """Plays a script from one node. The constructor publishes the lines that are due before the program starts.

    `simulated_time` maps a real time (`time.monotonic`, s) to simulated time (s). Wall time counts from `started_at`,
    which must be set when the program is started. `play` and `poll` never wait.
    """

    def __init__(self, node: Node, script: Script, simulated_time: Callable[[float], float]) -> None:
        self._simulated_time = simulated_time
        self._script = script
        self.started_at = time.monotonic()
        self._published: list[Published] = []
        self._calls: list[CallSeen] = []
        self._delay = _Delay()
        self._publishers = [
            (
                part,
                node.create_publisher(message_class(part.type), part.topic, _qos(part)),
                _Due([*part.lines], self._delay),
            )
            for part in script.parts
            if isinstance(part, Publishes)
        ]
        self._services = [
            _Offered(part, node.create_service(service_class(part.type), part.service, _never_called))
            for part in script.parts
            if isinstance(part, Serves)
        ]
        self._clients = [
            _Called(
                part,
                node.create_client(service_class(part.type), part.service),
                _Due([*part.lines], self._delay),
            )
            for part in script.parts
            if isinstance(part, Calls)
        ]
        self._say(BEFORE_START)

    def bytes_by_topic(self) -> dict[str, int]:
        """Return the total size (bytes) of the messages that the script publishes on each topic."""
        sizes: dict[str, int] = {}
        for part in self._script.parts:
            if isinstance(part, Publishes):
                kind = message_class(part.type)
                published = sum(len(serialize_message(fill(kind(), line.value))) for line in part.lines)
                sizes[part.topic] = sizes.get(part.topic, 0) + published
        return sizes

    def ready(self) -> bool:
        """Return whether the program subscribes to all awaited topics and offers all services that the script calls."""
        heard = all(
            publisher.get_subscription_count() > 0 for part, publisher, _ in self._publishers if part.awaited
        )
        return heard and all(called.client.service_is_ready() for called in self._clients)

    def play(self, t: float, *, keep_pauses: bool = False) -> None:
        """Send every line that is due at simulated time `t` (s), and handle requests and responses.

        With `keep_pauses`, a late line delays the lines after it by as much, so that the planned pauses don't shrink.
        """
        take = _Due.take_apart if keep_pauses else _Due.take
        self._say(t, take)
        for called in self._clients:
            for line in take(called.due, t):
                self._ask(called, line)
        self.poll()

    @property
    def late_s(self) -> float:
        """The delay (s) of the remaining lines."""
        return self._delay.late_s

    def _dues(self) -> list[_Due]:
        return [due for _, _, due in self._publishers] + [called.due for called in self._clients]

    def poll(self) -> None:
        """Take requests and responses that have arrived, and send the responses that are due."""
        for offered in self._services:
            self._serve(offered)
        for called in self._clients:
            self._collect(called)

    def until_next(self, t: float) -> float:
        """Return the simulated time, in seconds, from `t` to the next line, or infinity if there is none.

        If the script has a service or a client, the result is at most `SERVED_EVERY_S`, because a request or response
        may arrive at any time.
        """
        due = [one.next_at() - t for one in self._dues()]
        if self._services or self._clients:
            due.append(SERVED_EVERY_S)
        return max(0.0, min(due, default=math.inf))

    def published(self) -> tuple[Published, ...]:
        """Return the messages published so far, in order."""
        return tuple(self._published)

    def unpublished(self) -> tuple[Published, ...]:
        """Return the messages that are still to be published, in order, with their planned simulated times (s)."""
        to_come = [(part, line) for part, _, due in self._publishers for line in due.lines]
        return tuple(
            Published(part.topic, line.at, line.at, plain(fill(message_class(part.type)(), line.value)))
            for part, line in sorted(to_come, key=lambda one: one[1].at)
        )

    def calls(self) -> tuple[CallSeen, ...]:
        """Return the service calls seen so far, in both directions, sorted by wall time."""
        return tuple(sorted(self._calls, key=lambda call: call.wall))

    def _now(self) -> tuple[float, float]:
        moment = time.monotonic()
        return round(self._simulated_time(moment), 6), round(moment - self.started_at, 4)

    def _say(self, t: float, take: Callable[[_Due, float], list[Line]] = _Due.take) -> None:
        for part, publisher, due in sorted(self._publishers, key=lambda one: one[2].next_at()):
            for line in take(due, t):
                message = fill(message_class(part.type)(), line.value)
                now, wall = self._now()
                if line.at <= BEFORE_START:
                    now, wall = BEFORE_START, 0.0
                self._published.append(Published(part.topic, now, wall, plain(message)))
                publisher.publish(message)

    def _ask(self, called: "_Called", line: Line) -> None:
        request = fill(called.type.Request(), line.value)
        with called.client.handle:
            number = called.client.handle.send_request(request)
        called.open[number] = len(self._calls)
        self._calls.append(CallSeen(called.part.service, "judge", *self._now(), plain(request)))

    def _collect(self, called: "_Called") -> None:
        with called.client.handle:
            while True:
                header, response = called.client.handle.take_response(called.type.Response)
                if header is None:
                    return
                index = called.open.pop(header.request_id.sequence_number, None)
                if index is not None:
                    self._answered(index, plain(response))

    def _serve(self, offered: "_Offered") -> None:
        with offered.service.handle:
            while True:
                request, header = offered.service.handle.service_take_request(offered.type.Request)
                if header is None:
                    break
                if len(self._calls) >= CALLS_KEPT:
                    continue  # the request is still taken, so that it doesn't stay in the queue
                reply = offered.part.replies[min(offered.count, len(offered.part.replies) - 1)]
                offered.count += 1
                index = len(self._calls)
                self._calls.append(CallSeen(offered.part.service, "program", *self._now(), plain(request)))
                if reply.after is not None:
                    offered.waiting.append((self._now()[0] + reply.after, index, header, reply.value))
        now = self._now()[0] if offered.waiting else 0.0
        for due, index, header, value in [*offered.waiting]:
            if due <= now:
                offered.waiting.remove((due, index, header, value))
                response = fill(offered.type.Response(), value)
                offered.service.send_response(response, header)
                self._answered(index, plain(response))

    def _answered(self, index: int, response: Any) -> None:
        t, wall = self._now()
        self._calls[index] = replace(self._calls[index], response=response, answered_t=t, answered_wall=wall)


class _Offered:
    """A service that the script offers, with the requests that wait for a response."""

    def __init__(self, part: Serves, service: Any) -> None:
        self.part = part
        self.type = service_class(part.type)
        self.service = service
        self.count = 0
        self.waiting: list[tuple[float, int, Any, Mapping[str, Any]]] = []


class _Called:
    """A service of the program that the script calls, with our calls that wait for a response."""

    def __init__(self, part: Calls, client: Any, due: _Due) -> None:
        self.part = part
        self.type = service_class(part.type)
        self.client = client
        self.due = due
        self.open: dict[int, int] = {}


def _never_called(request: object, response: object) -> object:
    """Ignore a request. No executor serves the player's node, because `poll` takes the requests."""
    return response
