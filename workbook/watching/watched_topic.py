"""One topic while it is being recorded, and what of it goes into the recording."""

from dataclasses import dataclass, field
from typing import Any

from rclpy.duration import Infinite
from rclpy.serialization import deserialize_message

from workbook.recording.recording import Arrival, PublisherSeen, SubscriberSeen, TopicRecording
from workbook.watching.values import known_class, plain

NODE_UNKNOWN = "_NODE_NAME_UNKNOWN_"


@dataclass
class WatchedTopic:
    """One topic while it is being recorded."""

    name: str
    publishers: dict[bytes, PublisherSeen] = field(default_factory=dict)
    subscribers: dict[bytes, SubscriberSeen] = field(default_factory=dict)
    raw: list[tuple[float, float, float, bytes]] = field(default_factory=list)
    subscription: Any = None
    subscribed_type: str | None = None
    best_effort: bool = False
    matched_at: float | None = None
    not_kept: int = 0
    endpoints: tuple[int, int] = (0, 0)
    looks: int = 0

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


def finished(watched: WatchedTopic, end: float) -> TopicRecording:
    """The recording of a topic with its messages decoded; its window closes at robot time `end` (s)."""
    arrivals: list[Arrival] = []
    undecodable = 0
    message_type = None if watched.subscribed_type is None else known_class(watched.subscribed_type)
    for t, wall, sent, raw in watched.raw:
        if t > end:
            break
        try:
            value = plain(deserialize_message(raw, message_type))
        except Exception:  # bytes that are not trusted: whatever goes wrong, they are no message
            undecodable += 1
            continue
        arrivals.append(Arrival(round(t, 6), round(wall, 4), value, round(sent, 6)))
    return TopicRecording(
        name=watched.name,
        publishers=tuple(watched.publishers.values()),
        subscribers=tuple(watched.subscribers.values()),
        arrivals=tuple(arrivals),
        window=None if watched.matched_at is None else (watched.matched_at, end),
        undecodable=undecodable,
        not_kept=watched.not_kept,
    )
