"""Subscribe to every topic that other programs publish, and record the messages."""

import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from rclpy.node import Node, NodeNameNonExistentError
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy
from rclpy.topic_endpoint_info import TopicEndpointInfo

from workbook.recording.limits import FLOOD_MESSAGES, FLOOD_S
from workbook.recording.plan import BYTES_PER_TOPIC, Feature
from workbook.recording.recording import (
    NodeSeen,
    PublisherSeen,
    ServiceSeen,
    SubscriberSeen,
    TopicRecording,
)
from workbook.watching.graph_names import NO_NAME, PREFIX_BYTES, is_name, or_default, own_prefix
from workbook.watching.late_subscription import is_to_be_kept, received_late
from workbook.watching.message_quota import MessageQuota
from workbook.watching.values import known_class
from workbook.watching.watched_topic import (
    NODE_UNKNOWN,
    WatchedTopic,
    deadline_of,
    finished,
    full_name,
    gid_of,
    lifespan_of,
)

INFRASTRUCTURE = ("/rosout", "/parameter_events", "/clock")
KEPT_PER_TOPIC = 20_000
TOPICS_WATCHED = 64
TAKEN_AT_ONCE = 2_000
"""The most messages of one topic that are taken before the next topic's turn.

Because of this limit, a program that publishes faster than we can take messages doesn't stall the watch.
"""
PARAMETER_SERVICES = ("rcl_interfaces/srv/", "type_description_interfaces/srv/")
CLOCK_WAS_SET_S = 0.5
LOOKS_PER_LISTING = 5
_LOOK_AGAIN_S = 0.02


class Recorder:
    """Reads one context's graph, and records every topic that other programs publish.

    `simulated_time` maps a real time (`time.monotonic`, s) to simulated time (s). An arrival is stamped with the time
    at which DDS received the message, so a late `take` does no harm. Wall time counts from `started_at`. `look` reads
    changes in the graph, and `take` reads the messages; neither waits. Endpoints in the context of `node` are left out,
    but not other programs' endpoints with the same names. Invalid names are left out, too, without losing other topics.
    If topics can't be listed because of such a name, the `judged` topics are still recorded. Judged topics are also
    recorded if a program publishes more than `TOPICS_WATCHED` topics.

    Each judged topic has a quota of `KEPT_PER_TOPIC` messages and `bytes_per_topic` bytes; all other topics share one
    quota. The script's own messages don't count toward a quota: `own_bytes` is their total size by topic. `features`:
    see `Plan`. `on_take` is called with the recorder after each `take`.
    """

    def __init__(
        self,
        node: Node,
        started_at: float,
        simulated_time: Callable[[float], float],
        judged: tuple[str, ...] = (),
        bytes_per_topic: int = BYTES_PER_TOPIC,
        own_bytes: Mapping[str, int] | None = None,
        features: Mapping[str, Mapping[str, Feature]] | None = None,
        on_take: "OnTake | None" = None,
    ) -> None:
        self._on_take = on_take
        self._judged = judged
        self._bytes_per_topic = bytes_per_topic
        self._own_bytes = own_bytes or {}
        self._features = features or {}
        self._quota_of_others = MessageQuota(bytes_per_topic, KEPT_PER_TOPIC)
        self._node = node
        self._started_at = started_at
        self._simulated_time = simulated_time
        self._epoch_offset = time.time() - time.monotonic()
        self._own_name = node.get_fully_qualified_name()
        self._own_prefix = own_prefix(node)
        self._topics: dict[str, WatchedTopic] = {}
        self._nodes: dict[str, NodeSeen] = {}
        self._services: dict[tuple[str, str], ServiceSeen] = {}
        self._clients: dict[tuple[str, str], ServiceSeen] = {}

    def simulated_now(self) -> float:
        """Return the current simulated time (s)."""
        return self._simulated_time(time.monotonic())

    def _wall_now(self) -> float:
        return time.monotonic() - self._started_at

    def look(self) -> bool:
        """Read the graph once and subscribe to new topics. Return whether anything is new."""
        new = self.look_at_nodes()
        for topic in self._topic_names():
            try:
                new |= self._look_at(topic)
            except NO_NAME:  # an endpoint's node or type has an invalid name
                continue
        return new

    def look_at_nodes(self) -> bool:
        """Record the nodes that are in the graph now. Return whether any name is new."""
        new = False
        for full, how_many in self.present().items():
            known = self._nodes.get(full)
            if known is None:
                self._nodes[full] = NodeSeen(full, self._wall_now(), how_many)
                new = True
            elif known.most < how_many:
                self._nodes[full] = replace(known, most=how_many)
                new = True
        return new

    def _topic_names(self) -> list[str]:
        """Return the topics to record. If topics can't be listed, return the judged ones and those found earlier."""
        known = [(topic, [""]) for topic in dict.fromkeys((*self._judged, *self._topics))]
        listed = or_default(lambda: self._node.get_topic_names_and_types(no_demangle=False), known)
        return [topic for topic, _ in listed if topic not in INFRASTRUCTURE and is_name(topic)]

    def present(self) -> Counter[str]:
        """Count other programs' nodes that are in the graph now, by fully qualified name."""
        nobody: list[tuple[str, str]] = []
        names = or_default(self._node.get_node_names_and_namespaces, nobody)
        full = (full_name(namespace, name) for name, namespace in names if name != NODE_UNKNOWN)
        present = Counter(filter(is_name, full))
        return present - Counter([self._own_name])  # one of them is ours

    def look_at_services(self) -> None:
        """Record the services that other programs currently offer or have clients for, except parameter services.

        Skip nodes with our node's name: services are looked up by node name, so we couldn't tell such a node's services
        from ours.
        """
        for full in self.present():
            if full == self._own_name:
                continue
            namespace, _, name = full.rpartition("/")
            try:
                offered = self._node.get_service_names_and_types_by_node(name, namespace or "/")
                called = self._node.get_client_names_and_types_by_node(name, namespace or "/")
            except (
                NodeNameNonExistentError,
                *NO_NAME,
            ):  # the node has just left the graph, or has an invalid name
                continue
            self._services |= _own_services(offered)
            self._clients |= _own_services(called)

    def nodes_on_clock(self) -> tuple[str, ...]:
        """Return the fully qualified names of other programs' nodes that currently subscribe to /clock, sorted."""
        nothing: list[TopicEndpointInfo] = []
        found = or_default(lambda: self._node.get_subscriptions_info_by_topic("/clock"), nothing)
        others = (info for info in found if not self._is_own(gid_of(info)))
        return tuple(sorted({full_name(info.node_namespace, info.node_name) for info in others}))

    def look_who_stays(self, patience_s: float) -> None:
        """Wait up to `patience_s` (s) for the exited program's nodes to leave the graph, and record which ones stay."""
        deadline = time.monotonic() + patience_s
        while (left := self.present()) and time.monotonic() < deadline:
            time.sleep(_LOOK_AGAIN_S)
        self._nodes = {name: replace(node, stayed=name in left) for name, node in self._nodes.items()}

    def _look_at(self, topic: str) -> bool:
        watched = self._topics.get(topic)
        if watched is None:
            if len(self._topics) >= TOPICS_WATCHED and topic not in self._judged:
                return False
            watched = WatchedTopic(topic, self._quota_for(topic), self._features.get(topic, {}))
            self._topics[topic] = watched
        if not self._is_worth_a_look(watched):
            return False
        new = self._update_publishers(watched)
        self._update_subscribers(watched)
        self._subscribe(watched)
        if watched.matched_at is None and watched.subscription is not None:
            if watched.subscription.get_publisher_count() > 0:
                watched.matched_at = self.simulated_now()
                new = True
        return new

    def _quota_for(self, topic: str) -> MessageQuota:
        if topic not in self._judged and topic not in self._own_bytes:
            return self._quota_of_others
        return MessageQuota(self._bytes_per_topic + self._own_bytes.get(topic, 0), KEPT_PER_TOPIC)

    def _is_worth_a_look(self, watched: WatchedTopic) -> bool:
        """Return whether to list a topic's endpoints, which is expensive.

        We list endpoints if their number has changed, or if some information about them is still missing. Every few
        polls, we list them anyway, because one endpoint may have replaced another between two polls.
        """
        endpoints = (self._node.count_publishers(watched.name), self._node.count_subscribers(watched.name))
        watched.looks += 1
        if endpoints == watched.endpoints and watched.is_known() and watched.looks % LOOKS_PER_LISTING:
            return False
        watched.endpoints = endpoints
        return True

    def _update_publishers(self, watched: WatchedTopic) -> bool:
        present: set[bytes] = set()
        now = self.simulated_now()
        new = False
        for info in self._node.get_publishers_info_by_topic(watched.name):
            gid = gid_of(info)
            if self._is_own(gid):
                continue
            owner = full_name(info.node_namespace, info.node_name)
            present.add(gid)
            known = watched.publishers.get(gid)
            if known is None or known.node.endswith(NODE_UNKNOWN) or known.last_seen is not None:
                new |= known is None
                watched.publishers[gid] = PublisherSeen(
                    node=owner,
                    type=info.topic_type,
                    reliability=info.qos_profile.reliability.name.lower(),
                    durability=info.qos_profile.durability.name.lower(),
                    first_seen=now if known is None else known.first_seen,
                    deadline=deadline_of(info),
                    lifespan=lifespan_of(info),
                )
        for gid, publisher in watched.publishers.items():
            if gid not in present and publisher.last_seen is None:
                watched.publishers[gid] = replace(publisher, last_seen=now)
        return new

    def _is_own(self, gid: bytes) -> bool:
        """Return whether an endpoint belongs to our own context."""
        return gid[:PREFIX_BYTES] == self._own_prefix

    def _update_subscribers(self, watched: WatchedTopic) -> None:
        for info in self._node.get_subscriptions_info_by_topic(watched.name):
            gid = gid_of(info)
            if not self._is_own(gid):
                watched.subscribers[gid] = SubscriberSeen(
                    node=full_name(info.node_namespace, info.node_name),
                    type=info.topic_type,
                    reliability=info.qos_profile.reliability.name.lower(),
                    durability=info.qos_profile.durability.name.lower(),
                    deadline=deadline_of(info),
                )

    def _subscribe(self, watched: WatchedTopic) -> None:
        best_effort = any(publisher.reliability == "best_effort" for publisher in watched.publishers.values())
        if watched.subscription is not None:
            if best_effort and not watched.best_effort:
                self._node.destroy_subscription(watched.subscription)
                watched.subscription = None
            else:
                return
        for publisher in watched.publishers.values():
            message_type = known_class(publisher.type)
            if message_type is None:
                continue
            watched.best_effort = best_effort
            watched.subscribed_type = publisher.type
            watched.subscription = self._node.create_subscription(
                message_type,
                watched.name,
                _never_called,
                QoSProfile(
                    history=HistoryPolicy.KEEP_LAST,
                    depth=1000,
                    reliability=ReliabilityPolicy.BEST_EFFORT if best_effort else ReliabilityPolicy.RELIABLE,
                    durability=DurabilityPolicy.VOLATILE,
                ),
                raw=True,
            )
            return

    def take(self) -> None:
        """Keep the messages that have arrived since the last call."""
        offset = time.time() - time.monotonic()
        if abs(offset - self._epoch_offset) > CLOCK_WAS_SET_S:  # messages are stamped with the time of day
            self._epoch_offset = offset
        for watched in self._topics.values():
            if watched.subscription is None:
                continue
            with watched.subscription.handle:
                for _ in range(TAKEN_AT_ONCE):
                    taken = watched.subscription.handle.take_message(watched.subscription.msg_type, True)
                    if taken is None:
                        break
                    raw, info = taken
                    received, sent = (info[f"{end}_timestamp"] / 1e9 for end in ("received", "source"))
                    self._keep(watched, raw, received - self._epoch_offset, sent - self._epoch_offset)
        if self._on_take is not None:
            self._on_take(self)

    def kept_until_now(self) -> dict[str, int | None]:
        """Return, by topic, the number of earlier messages that a new subscription still receives.

        This includes only judged topics on which a publisher offers to keep messages. For None, see `received_late`.
        """
        judged = (self._topics[name] for name in self._judged if name in self._topics)
        return {one.name: received_late(self._node, one) for one in judged if is_to_be_kept(one)}

    def discard(self) -> None:
        """Drop the messages that arrived before the watch began."""
        self.take()
        for watched in self._topics.values():
            watched.forget()

    def _keep(self, watched: WatchedTopic, raw: bytes, moment: float, sent: float) -> None:
        wall = moment - self._started_at
        watched.keep(self._simulated_time(moment), wall, sent - self._started_at, raw)

    def so_far(self) -> Iterator[tuple[str, str, int, Any]]:
        """Yield the name, type, number of messages, and last message (see `latest`) of each topic with messages."""
        for name, watched in sorted(self._topics.items()):
            if watched.came:
                yield name, watched.subscribed_type or "", len(watched.came), watched.latest()

    def matched(self, topic: str) -> bool:
        """Return whether the recorder's own subscription to `topic` is connected to a publisher."""
        watched = self._topics.get(topic)
        return watched is not None and watched.matched_at is not None

    def times(self, topic: str) -> list[float]:
        """Return the arrival times (simulated time, s) of the messages on `topic`, up to the last `take`."""
        watched = self._topics.get(topic)
        return [] if watched is None else [one.t for one in watched.came]

    def is_flooded(self, topic: str) -> bool:
        """Return whether a topic's latest messages arrived faster than any exercise requires."""
        watched = self._topics.get(topic)
        came = [] if watched is None else watched.came[-FLOOD_MESSAGES:]
        return len(came) == FLOOD_MESSAGES and came[-1].t - came[0].t < FLOOD_S

    def matched_at(self, topic: str) -> float | None:
        """Return the simulated time (s) at which our subscription to `topic` was matched, or None if it wasn't."""
        watched = self._topics.get(topic)
        return None if watched is None else watched.matched_at

    def has_unmatched_publisher(self, topic: str) -> bool:
        """Return whether a program publishes on `topic`, but the recorder's own subscription isn't connected yet."""
        return not self.matched(topic) and self._node.count_publishers(topic) > 0

    def knows_its_nodes(self) -> bool:
        """Return whether every current publisher's node is known.

        ROS 2 announces node names separately from publishers, so a node may still be unknown.
        """
        return all(
            publisher.node in self._nodes
            for watched in self._topics.values()
            for publisher in watched.publishers.values()
            if publisher.last_seen is None
        )

    def any_publisher(self) -> bool:
        """Return whether a recorded topic has or had a publisher."""
        return any(watched.publishers for watched in self._topics.values())

    def nodes(self) -> tuple[NodeSeen, ...]:
        """Return all nodes seen so far, sorted by fully qualified name."""
        return tuple(self._nodes[name] for name in sorted(self._nodes))

    def services(self) -> tuple[ServiceSeen, ...]:
        """Return all services that nodes have offered so far, sorted."""
        return tuple(self._services[key] for key in sorted(self._services))

    def clients(self) -> tuple[ServiceSeen, ...]:
        """Return all services for which nodes have had clients so far, sorted."""
        return tuple(self._clients[key] for key in sorted(self._clients))

    def start_windows(self, t: float) -> None:
        """Begin the watch at simulated time `t` (s). Earlier matches and endpoints count as found at `t`.

        On the wall clock, simulated time begins only now, so times recorded earlier would be wrong.
        """
        for watched in self._topics.values():
            if watched.matched_at is not None:
                watched.matched_at = t
            for gid, publisher in watched.publishers.items():
                last_seen = None if publisher.last_seen is None else t
                watched.publishers[gid] = replace(publisher, first_seen=t, last_seen=last_seen)

    def topics(self, end: float) -> dict[str, TopicRecording]:
        """Return each topic's recording up to simulated time `end` (s)."""
        return {name: finished(watched, end) for name, watched in sorted(self._topics.items())}


def _own_services(found: list[tuple[str, list[str]]]) -> dict[tuple[str, str], ServiceSeen]:
    """Return the services by name and type, without those that every node offers."""
    return {
        (service, kind): ServiceSeen(service, kind)
        for service, types in found
        for kind in types
        if not kind.startswith(PARAMETER_SERVICES)
    }


def _never_called(message: object) -> None:
    """Ignore a message. No executor serves the recorder's node, because `take` fetches the messages."""


OnTake = Callable[[Recorder], None]
