"""One topic while it is being recorded, and what of it goes into the recording."""

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
"""So many messages that are not kept are counted, with the moments at which they came."""
LARGE_MESSAGE_BYTES = 16_000
"""A larger message is decoded at once, so that only what is kept of it takes memory."""
LARGE_COSTS = 1 / 50
"""Share of its size that a large message takes of the room for its topic, besides what is kept of it: reading it takes
time."""
AWAITED_COSTS = 1 / 1000
"""The same of a topic for which an exercise has said what to keep of large fields. Ten seconds of a camera (640 by 480
pixels, 30 images a second) then take half of the usual room."""


class RawArrival(NamedTuple):
    """A message as it came: in simulated time, wall time, when it was sent (s), and its bytes or its large value."""

    t: float
    wall: float
    sent: float
    raw: bytes
    value: Any = None


@dataclass
class WatchedTopic:
    """One topic while it is being recorded."""

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
        """Keep a message, or when it came, if it is broken or there is no room for it. `t`: simulated time (s)."""
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
        """Take so much of the room. What comes once it is used up is not kept, however small."""
        if self.quota.take(size, messages):
            return True
        self._note(self.without_room, t)
        return False

    @staticmethod
    def _note(moments: list[float], t: float) -> None:
        if len(moments) < MOST_NOTED:
            moments.append(t)

    def decoded(self, raw: bytes) -> Any | None:
        """A message as plain data; None if the bytes are none of the type of this topic."""
        message_type = None if self.subscribed_type is None else known_class(self.subscribed_type)
        try:
            message = deserialize_message(raw, message_type)
            return with_features(plain(message), message, self.features)
        except Exception:  # bytes that are not trusted: whatever goes wrong, they are no message
            return None

    def latest(self) -> Any | None:
        """The last message as plain data; None for one that is broken or too large to be shown."""
        last = self.came[-1]
        value = self.decoded(last.raw) if last.value is None else last.value
        return value if bytes_kept(value) <= SHOWN_BYTES else None

    def forget(self) -> None:
        """Drop what has come so far."""
        for moments in (self.came, self.undecodable, self.too_large, self.without_room):
            moments.clear()
        self.quota.clear()

    def is_known(self) -> bool:
        """Whether all that can be known of its endpoints is known."""
        ends: list[PublisherSeen | SubscriberSeen] = [*self.publishers.values(), *self.subscribers.values()]
        named = not any(end.node.endswith(NODE_UNKNOWN) for end in ends)
        return named and (self.subscription is None or self.matched_at is not None)


def full_name(namespace: str, name: str) -> str:
    """The fully qualified name of a node; the namespace may end with a slash."""
    return f"{namespace.rstrip('/')}/{name}"


def gid_of(info: Any) -> bytes:
    """The DDS identifier of an endpoint."""
    return bytes(info.endpoint_gid)


def deadline_of(info: Any) -> float | None:
    """The deadline of an endpoint (s); None if it has none."""
    deadline = info.qos_profile.deadline
    return None if deadline.nanoseconds >= Infinite.nanoseconds else deadline.nanoseconds / 1e9


def lifespan_of(info: Any) -> float | None:
    """How long (s) a publisher keeps a message for others; None if for ever."""
    lifespan = info.qos_profile.lifespan
    return None if lifespan.nanoseconds >= Infinite.nanoseconds else lifespan.nanoseconds / 1e9


def finished(watched: WatchedTopic, end: float) -> TopicRecording:
    """Decode what came on a topic from the start to simulated time `end` (s)."""
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
