"""Record one topic: keep its messages, and convert them to a `TopicRecording`."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from rclpy.duration import Infinite
from rclpy.serialization import deserialize_message

from workbook.recording.plan import Feature
from workbook.recording.recording import Arrival, PublisherSeen, SubscriberSeen, TopicRecording
from workbook.watching.message_quota import MessageQuota
from workbook.watching.values import bytes_kept, known_class, plain, with_features

NODE_UNKNOWN = "_NODE_NAME_UNKNOWN_"
LARGEST_MESSAGE_BYTES = 4_000_000
SHOWN_BYTES = 1_000
MOST_NOTED = 2_000
"""The most arrival times recorded for each kind of message that isn't kept (broken, too large, or over the quota)."""
LARGE_MESSAGE_BYTES = 16_000
"""Larger messages (in bytes) are decoded right away, so that only the part that we keep takes up memory."""
LARGE_COSTS = 1 / 50
"""The fraction of a large message's size that counts toward its topic's quota, because decoding takes time.

The size of the part that we keep counts, too.
"""
AWAITED_COSTS = 1 / 1000
"""The same fraction if an exercise declares features of the topic's large fields.

Ten seconds of camera images (640 by 480 pixels, 30 Hz) then take half of the usual quota.
"""


class RawArrival(NamedTuple):
    """A message with its arrival time.

    `t`: its arrival time (simulated time, s). `wall` and `sent`: the times at which it arrived and was sent (wall time,
    s). `raw`: its bytes. `value`: instead of its bytes, a large message's plain data.
    """

    t: float
    wall: float
    sent: float
    raw: bytes
    value: Any = None


@dataclass
class WatchedTopic:
    """The state of a topic while it's being recorded."""

    name: str
    quota: MessageQuota
    features: Mapping[str, Feature] = field(default_factory=dict)
    publishers: dict[bytes, PublisherSeen] = field(default_factory=dict)
    subscribers: dict[bytes, SubscriberSeen] = field(default_factory=dict)
    came: list[RawArrival] = field(default_factory=list)
    undecodable: list[float] = field(default_factory=list)
    too_large: list[float] = field(default_factory=list)
    without_room: list[float] = field(default_factory=list)
    subscription: Any = None
    subscribed_type: str | None = None
    best_effort: bool = False
    matched_at: float | None = None
    endpoints: tuple[int, int] = (0, 0)
    looks: int = 0

    def keep(self, t: float, wall: float, sent: float, raw: bytes) -> None:
        """Keep a message.

        If the message is broken or too large, or exceeds the quota, keep only its arrival time `t` (simulated time, s).
        """
        if len(raw) > LARGEST_MESSAGE_BYTES:
            self._note(self.too_large, t)
        elif len(raw) <= LARGE_MESSAGE_BYTES:
            if self._has_room(len(raw), t):
                self.came.append(RawArrival(t, wall, sent, raw))
        elif self._has_room(round((AWAITED_COSTS if self.features else LARGE_COSTS) * len(raw)), t):
            value = self.decoded(raw)
            if value is None:
                self._note(self.undecodable, t)
            elif self._has_room(bytes_kept(value), t, messages=0):
                self.came.append(RawArrival(t, wall, sent, b"", value))

    def _has_room(self, size: int, t: float, messages: int = 1) -> bool:
        """Take `size` bytes from the quota, and return whether they fit.

        If they don't fit, no later message is kept, however small.
        """
        if self.quota.take(size, messages):
            return True
        self._note(self.without_room, t)
        return False

    @staticmethod
    def _note(moments: list[float], t: float) -> None:
        if len(moments) < MOST_NOTED:
            moments.append(t)

    def decoded(self, raw: bytes) -> Any | None:
        """Decode a message to plain data, or None if the bytes don't fit the topic's type."""
        message_type = None if self.subscribed_type is None else known_class(self.subscribed_type)
        try:
            message = deserialize_message(raw, message_type)
            return with_features(plain(message), message, self.features)
        except Exception:  # untrusted bytes: after any error, they count as undecodable
            return None

    def latest(self) -> Any | None:
        """Return the last message as plain data, or None if it's broken or too large to show."""
        last = self.came[-1]
        value = self.decoded(last.raw) if last.value is None else last.value
        return value if bytes_kept(value) <= SHOWN_BYTES else None

    def forget(self) -> None:
        """Drop the messages that have arrived so far."""
        for moments in (self.came, self.undecodable, self.too_large, self.without_room):
            moments.clear()
        self.quota.clear()

    def is_known(self) -> bool:
        """Return whether the nodes of all endpoints are known, and our subscription, if any, is matched."""
        ends: list[PublisherSeen | SubscriberSeen] = [*self.publishers.values(), *self.subscribers.values()]
        named = not any(end.node.endswith(NODE_UNKNOWN) for end in ends)
        return named and (self.subscription is None or self.matched_at is not None)


def full_name(namespace: str, name: str) -> str:
    """Return a node's fully qualified name. The namespace may end with a slash."""
    return f"{namespace.rstrip('/')}/{name}"


def gid_of(info: Any) -> bytes:
    """Return an endpoint's DDS identifier (GID)."""
    return bytes(info.endpoint_gid)


def deadline_of(info: Any) -> float | None:
    """Return an endpoint's deadline (s), or None if it has none."""
    deadline = info.qos_profile.deadline
    return None if deadline.nanoseconds >= Infinite.nanoseconds else deadline.nanoseconds / 1e9


def lifespan_of(info: Any) -> float | None:
    """Return a publisher's lifespan (s), after which its messages expire, or None if they don't expire."""
    lifespan = info.qos_profile.lifespan
    return None if lifespan.nanoseconds >= Infinite.nanoseconds else lifespan.nanoseconds / 1e9


def finished(watched: WatchedTopic, end: float) -> TopicRecording:
    """Decode a topic's messages up to simulated time `end` (s), and return the topic's recording."""
    arrivals: list[Arrival] = []
    undecodable = [t for t in watched.undecodable if t <= end]
    too_large = [t for t in watched.too_large if t <= end]
    without_room = [t for t in watched.without_room if t <= end]
    for one in watched.came:
        if one.t > end:
            break
        value = one.value if one.value is not None else watched.decoded(one.raw)
        if value is None:
            undecodable.append(one.t)
        else:
            arrivals.append(Arrival(round(one.t, 6), round(one.wall, 4), value, round(one.sent, 6)))
    broken_at = min((*undecodable, *too_large), default=None)
    return TopicRecording(
        name=watched.name,
        publishers=tuple(watched.publishers.values()),
        subscribers=tuple(watched.subscribers.values()),
        arrivals=tuple(arrivals),
        window=None if watched.matched_at is None else (watched.matched_at, end),
        undecodable=len(undecodable),
        not_kept=len(too_large) + len(without_room),
        too_large=len(too_large),
        broken_at=None if broken_at is None else round(broken_at, 6),
        full_at=round(without_room[0], 6) if without_room else None,
        room=watched.quota.most_bytes if without_room and watched.quota.is_short_of_bytes else None,
    )
