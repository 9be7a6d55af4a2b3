"""Subscribes by itself to whatever others publish, and keeps what arrives."""

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
"""So many messages of a topic are taken before others are looked after: whoever publishes faster than they can be taken
must not stop the watch."""
PARAMETER_SERVICES = ("rcl_interfaces/srv/", "type_description_interfaces/srv/")
CLOCK_WAS_SET_S = 0.5
LOOKS_PER_LISTING = 5
_LOOK_AGAIN_S = 0.02


class Recorder:
    """Watches the graph of one context and records every topic that somebody else publishes.

    `simulated_time` maps a moment of `time.monotonic` (s) to simulated time (s); an arrival is stamped with the moment
    at which DDS received it, so it does not matter how late `take` is called. `started_at` is the zero of wall time.
    `look` takes in changes of the graph, `take` the messages; neither waits. What belongs to the context of `node` is
    left out, however others call themselves. Names that are none are left out, too, and cost no other topic: where one
    of them keeps the topics from being listed, the `judged` ones are still looked at. These are recorded even when a
    program publishes more topics than are watched otherwise.

    Of each judged topic so many messages and `bytes_per_topic` are kept, and as much of all others together. What we
    publish ourselves is not counted: `own_bytes` says how much that is, by topic. `features`: see `Plan`.
    `on_take` is called with the recorder after each `take`.
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

    def robot_now(self) -> float:
        """Simulated time (s)."""
        return self._simulated_time(time.monotonic())

    def _wall_now(self) -> float:
        return time.monotonic() - self._started_at

    def look(self) -> bool:
        """Read the graph once and subscribe to new topics. Returns whether anything is new."""
        new = self.look_at_nodes()
        for topic in self._topic_names():
            try:
                new |= self._look_at(topic)
            except NO_NAME:  # of a node or a type that others know it by
                continue
        return new

    def look_at_nodes(self) -> bool:
        """Note the nodes that are on the graph now. Returns whether one is new."""
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
        """Topics that may be recorded; if nobody can list them, those that are judged or known."""
        known = [(topic, [""]) for topic in dict.fromkeys((*self._judged, *self._topics))]
        listed = or_default(lambda: self._node.get_topic_names_and_types(no_demangle=False), known)
        return [topic for topic, _ in listed if topic not in INFRASTRUCTURE and is_name(topic)]

    def present(self) -> Counter[str]:
        """Count the nodes of others that are on the graph now, by fully qualified name."""
        nobody: list[tuple[str, str]] = []
        names = or_default(self._node.get_node_names_and_namespaces, nobody)
        full = (full_name(namespace, name) for name, namespace in names if name != NODE_UNKNOWN)
        present = Counter(filter(is_name, full))
        return present - Counter([self._own_name])  # one of them is ours

    def look_at_services(self) -> None:
        """Note the services that others offer or call now, those of every node's parameters left out.

        Of a node that is called like ours nothing can be told: what is ours and what is theirs goes by name here.
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
            ):  # it has gone in this moment, or offers what has no name
                continue
            self._services |= _own_services(offered)
            self._clients |= _own_services(called)

    def nodes_on_clock(self) -> tuple[str, ...]:
        """The fully qualified names of nodes of others that subscribe to /clock now, sorted, each once."""
        nothing: list[TopicEndpointInfo] = []
        found = or_default(lambda: self._node.get_subscriptions_info_by_topic("/clock"), nothing)
        others = (info for info in found if not self._is_own(gid_of(info)))
        return tuple(sorted({full_name(info.node_namespace, info.node_name) for info in others}))

    def look_who_stays(self, patience_s: float) -> None:
        """After the program has ended: note which of its nodes are still on the graph when `patience_s` is over."""
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
                watched.matched_at = self.robot_now()
                new = True
        return new

    def _quota_for(self, topic: str) -> MessageQuota:
        if topic not in self._judged and topic not in self._own_bytes:
            return self._quota_of_others
        return MessageQuota(self._bytes_per_topic + self._own_bytes.get(topic, 0), KEPT_PER_TOPIC)

    def _is_worth_a_look(self, watched: WatchedTopic) -> bool:
        """Whether its endpoints must be listed, which is dear: where their number or our knowledge says so.

        Now and then in any case: one may have come in the moment in which another one went.
        """
        endpoints = (self._node.count_publishers(watched.name), self._node.count_subscribers(watched.name))
        watched.looks += 1
        if endpoints == watched.endpoints and watched.is_known() and watched.looks % LOOKS_PER_LISTING:
            return False
        watched.endpoints = endpoints
        return True

    def _update_publishers(self, watched: WatchedTopic) -> bool:
        present: set[bytes] = set()
        now = self.robot_now()
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
        """Whether an endpoint belongs to our own context."""
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
        if abs(offset - self._epoch_offset) > CLOCK_WAS_SET_S:  # messages carry the time of day
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
        """How many messages each judged topic that promises to keep them has kept for a subscription made now."""
        judged = (self._topics[name] for name in self._judged if name in self._topics)
        return {one.name: received_late(self._node, one) for one in judged if is_to_be_kept(one)}

    def discard(self) -> None:
        """Drop what has arrived so far: it came before the watch began."""
        self.take()
        for watched in self._topics.values():
            watched.forget()

    def _keep(self, watched: WatchedTopic, raw: bytes, moment: float, sent: float) -> None:
        wall = moment - self._started_at
        watched.keep(self._simulated_time(moment), wall, sent - self._started_at, raw)

    def so_far(self) -> Iterator[tuple[str, int, Any]]:
        """Each topic on which something came: how many messages were kept, and the last one as `latest` has it."""
        for name, watched in sorted(self._topics.items()):
            if watched.came:
                yield name, len(watched.came), watched.latest()

    def matched(self, topic: str) -> bool:
        """Whether the recorder's own subscription to `topic` is connected to a publisher."""
        watched = self._topics.get(topic)
        return watched is not None and watched.matched_at is not None

    def times(self, topic: str) -> list[float]:
        """When messages of `topic` came, up to the last `take` (s of simulated time)."""
        watched = self._topics.get(topic)
        return [] if watched is None else [one.t for one in watched.came]

    def is_flooded(self, topic: str) -> bool:
        """Whether the latest messages of a topic came so fast that no rate of an exercise can be right any more."""
        watched = self._topics.get(topic)
        came = [] if watched is None else watched.came[-FLOOD_MESSAGES:]
        return len(came) == FLOOD_MESSAGES and came[-1].t - came[0].t < FLOOD_S

    def matched_at(self, topic: str) -> float | None:
        """Since when (s of simulated time) `topic` has been recorded; None if it never was."""
        watched = self._topics.get(topic)
        return None if watched is None else watched.matched_at

    def has_unmatched_publisher(self, topic: str) -> bool:
        """Whether somebody publishes `topic`, and the recorder's own subscription is not connected yet."""
        return not self.matched(topic) and self._node.count_publishers(topic) > 0

    def knows_its_nodes(self) -> bool:
        """Whether each publisher that is there belongs to a node that we know; names travel apart from publishers."""
        return all(
            publisher.node in self._nodes
            for watched in self._topics.values()
            for publisher in watched.publishers.values()
            if publisher.last_seen is None
        )

    def any_publisher(self) -> bool:
        """Whether anything has published any recorded topic, now or before."""
        return any(watched.publishers for watched in self._topics.values())

    def nodes(self) -> tuple[NodeSeen, ...]:
        """All nodes seen so far, sorted by fully qualified name."""
        return tuple(self._nodes[name] for name in sorted(self._nodes))

    def services(self) -> tuple[ServiceSeen, ...]:
        """All services that a node has offered so far, sorted."""
        return tuple(self._services[key] for key in sorted(self._services))

    def clients(self) -> tuple[ServiceSeen, ...]:
        """All services that a node has had a client for so far, sorted."""
        return tuple(self._clients[key] for key in sorted(self._clients))

    def start_windows(self, t: float) -> None:
        """Begin the watch at simulated time `t`: what was matched or seen before counts from then.

        On the wall clock, simulated time begins only now, so earlier moments mean nothing any more.
        """
        for watched in self._topics.values():
            if watched.matched_at is not None:
                watched.matched_at = t
            for gid, publisher in watched.publishers.items():
                last_seen = None if publisher.last_seen is None else t
                watched.publishers[gid] = replace(publisher, first_seen=t, last_seen=last_seen)

    def topics(self, end: float) -> dict[str, TopicRecording]:
        """What was recorded up to simulated time `end` (s)."""
        return {name: finished(watched, end) for name, watched in sorted(self._topics.items())}


def _own_services(found: list[tuple[str, list[str]]]) -> dict[tuple[str, str], ServiceSeen]:
    """Services by name and type, without those that every node has."""
    return {
        (service, kind): ServiceSeen(service, kind)
        for service, types in found
        for kind in types
        if not kind.startswith(PARAMETER_SERVICES)
    }


def _never_called(message: object) -> None:
    """No executor serves the recorder's node: `take` fetches the messages."""


OnTake = Callable[[Recorder], None]
