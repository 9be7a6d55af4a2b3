"""Read the ROS graph as data, for a notebook or a terminal, as the `ros2` command does.

Each function reads this notebook's domain, or another `domain`, and includes nodes of this kernel and of other
processes. The result is plain data that notebooks show as an HTML table and terminals as text. Hidden entries (names
that begin with an underscore, /rosout, /parameter_events, parameter services) are left out unless `hidden=True`.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import Any, NamedTuple

from rclpy.duration import Duration, Infinite
from rclpy.node import Node
from rclpy.qos import QoSCompatibility, qos_check_compatible
from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden

from workbook.ros.discovery import NODE_UNKNOWN, discovery_node, wait_for_graph
from workbook.ros.tables import Shown, Table

_HIDDEN_TOPICS = ("/rosout", "/parameter_events")
_NODE_SERVICES = (
    "describe_parameters",
    "get_parameter_types",
    "get_parameters",
    "get_type_description",
    "list_parameters",
    "set_parameters",
    "set_parameters_atomically",
)


class NotFound(LookupError):
    """Raised when no node or topic has a given name. The message lists the existing ones."""


class TopicSummary(NamedTuple):
    """One topic of `topic_list`."""

    name: str
    types: tuple[str, ...]
    publishers: int
    subscribers: int


class Endpoint(NamedTuple):
    """A topic's publisher or subscription. QoS values are strings, such as "best effort" or "0.5 s"."""

    node: str
    type: str
    reliability: str
    durability: str
    deadline: str


class Edge(NamedTuple):
    """An arrow of the graph. `role` is "publishes" or "subscribes"."""

    node: str
    role: str
    topic: str


class Broken(NamedTuple):
    """A topic's publisher and subscription that can't exchange messages, and the reason as a sentence."""

    topic: str
    writer: str
    reader: str
    reason: str


class NodeList(Shown, tuple[str, ...]):
    """Fully qualified node names, sorted. A name appears once for each node that has it."""

    def _tables(self) -> list[Table]:
        rows = []
        for name in sorted(set(self)):
            count = self.count(name)
            rows.append((name if count == 1 else f"{name}  ({count} nodes with this name)",))
        return [Table("Nodes", ("node",), tuple(rows), "No nodes.")]

    def text(self, columns: int | None = None) -> str:
        """Return one name per line."""
        table = self._tables()[0]
        return "\n".join(row[0] for row in table.rows) or table.empty


class TopicList(Shown, tuple[TopicSummary, ...]):
    """Topics, sorted by name."""

    with_types = True

    @property
    def names(self) -> list[str]:
        """The topics' names."""
        return [topic.name for topic in self]

    def _tables(self) -> list[Table]:
        if not self.with_types:
            return [Table("Topics", ("topic",), tuple((name,) for name in self.names), "No topics.")]
        rows = tuple((t.name, ", ".join(t.types), str(t.publishers), str(t.subscribers)) for t in self)
        return [Table("Topics", ("topic", "type", "publishers", "subscribers"), rows, "No topics.")]


@dataclass(frozen=True, repr=False)
class NodeInfo(Shown):
    """A node's topics and services, as pairs of name and type."""

    name: str
    publishes: tuple[tuple[str, str], ...]
    subscribes: tuple[tuple[str, str], ...]
    serves: tuple[tuple[str, str], ...]
    calls: tuple[tuple[str, str], ...]

    def _tables(self) -> list[Table]:
        parts = [
            ("publishes", self.publishes),
            ("subscribes", self.subscribes),
            ("serves", self.serves),
            ("calls", self.calls),
        ]
        rows = tuple((role, name, kind) for role, pairs in parts for name, kind in pairs)
        return [
            Table(
                f"Node {self.name}",
                ("does", "name", "type"),
                rows,
                f"{self.name} exchanges messages with no other node.",
            )
        ]


@dataclass(frozen=True, repr=False)
class TopicInfo(Shown):
    """A topic's publishers and subscriptions, with their QoS. `problems` describes incompatible pairs."""

    name: str
    types: tuple[str, ...]
    publishers: tuple[Endpoint, ...]
    subscribers: tuple[Endpoint, ...]
    problems: tuple[str, ...] = ()

    def _tables(self) -> list[Table]:
        header = ("role", "node", "type", "reliability", "durability", "deadline")
        rows = [("publishes", *endpoint) for endpoint in self.publishers]
        rows += [("subscribes", *endpoint) for endpoint in self.subscribers]
        title = f"Topic {self.name}"
        return [Table(title, header, tuple(rows), f"No node publishes or subscribes to {self.name}.")]

    def _notes(self) -> list[str]:
        return [f"✗ {problem}" for problem in self.problems]


@dataclass(frozen=True, repr=False)
class Graph(Shown):
    """Nodes, topics with their types, and the arrows between them, all sorted.

    `broken`: pairs of a publisher and a subscription that can't exchange messages.
    """

    nodes: tuple[str, ...]
    topics: dict[str, tuple[str, ...]] = field(hash=False)
    edges: tuple[Edge, ...]
    broken: tuple[Broken, ...] = ()

    def _tables(self) -> list[Table]:
        rows = []
        for name, types in self.topics.items():
            writers = [edge.node for edge in self.edges if edge.topic == name and edge.role == "publishes"]
            readers = [edge.node for edge in self.edges if edge.topic == name and edge.role == "subscribes"]
            cut = {(one.writer, one.reader) for one in self.broken if one.topic == name}
            deaf = [reader for reader in readers if writers and {(one, reader) for one in writers} <= cut]
            arrow = f"→ {name} ✗" if deaf and len(deaf) == len(readers) else f"→ {name} →"
            some = arrow.endswith("→")
            heard = [f"✗ {reader}" if some and reader in deaf else reader for reader in readers]
            rows.append((", ".join(writers) or "–", arrow, ", ".join(heard) or "–", ", ".join(types)))
        busy = {edge.node for edge in self.edges}
        rows += [(node, "", "", "") for node in self.nodes if node not in busy]
        return [Table("Graph", ("publishers", "topic", "subscribers", "type"), tuple(rows), "No nodes.")]

    def _notes(self) -> list[str]:
        return [f"✗ {one.topic}: {one.reason}" for one in self.broken]

    def text(self, columns: int | None = None) -> str:
        """Return one topic per line, with its type on the next line if the line is too long.

        The reasons for broken arrows follow.
        """
        (table,) = self._tables()
        text = table.text()
        if columns is not None and max(map(len, text.splitlines())) > columns:
            text = "\n".join(
                f"{writers} {arrow} {readers}\n    {kind}" if arrow else writers
                for writers, arrow, readers, kind in table.rows
            )
        return "\n\n".join([text, *self._notes()])


def fully_qualified_name(name: str, namespace: str) -> str:
    """Return a node's name with its namespace, such as "/arm/gripper"."""
    return f"{namespace.rstrip('/')}/{name}"


def _is_hidden_node(name: str) -> bool:
    return any(part.startswith("_") for part in name.split("/"))


def _is_hidden_topic(name: str) -> bool:
    return name in _HIDDEN_TOPICS or topic_or_service_is_hidden(name)


def _nodes(node: Node, hidden: bool) -> list[str]:
    own = node.get_fully_qualified_name()
    names = [
        fully_qualified_name(*pair)
        for pair in node.get_node_names_and_namespaces()
        if pair[0] != NODE_UNKNOWN
    ]
    return sorted(name for name in names if name != own and (hidden or not _is_hidden_node(name)))


def _topics(node: Node, hidden: bool) -> dict[str, tuple[str, ...]]:
    known = sorted(node.get_topic_names_and_types())
    return {name: tuple(sorted(types)) for name, types in known if hidden or not _is_hidden_topic(name)}


def _endpoints(node: Node, infos: Iterable[Any], hidden: bool) -> list[Any]:
    own = node.get_fully_qualified_name()
    named = [(fully_qualified_name(info.node_name, info.node_namespace), info) for info in infos]
    kept = [(name, info) for name, info in named if name != own and (hidden or not _is_hidden_node(name))]
    return [info for _, info in sorted(kept, key=lambda pair: (pair[0], bytes(pair[1].endpoint_gid)))]


def _publishers(node: Node, topic: str, hidden: bool) -> list[Any]:
    return _endpoints(node, node.get_publishers_info_by_topic(topic), hidden)


def _subscribers(node: Node, topic: str, hidden: bool) -> list[Any]:
    return _endpoints(node, node.get_subscriptions_info_by_topic(topic), hidden)


def _seconds(duration: Duration) -> str:
    return "none" if duration.nanoseconds >= Infinite.nanoseconds else f"{duration.nanoseconds / 1e9:g} s"


def _word(policy: Any) -> str:
    return str(policy.name).lower().replace("_", " ")


def _endpoint(info: Any) -> Endpoint:
    qos = info.qos_profile
    return Endpoint(
        fully_qualified_name(info.node_name, info.node_namespace),
        info.topic_type,
        _word(qos.reliability),
        _word(qos.durability),
        _seconds(qos.deadline),
    )


def not_found(kind: str, name: str, known: Iterable[str]) -> NotFound:
    """Return the exception for a missing name, which suggests the most similar existing name."""
    names = sorted(set(known))
    if not names:
        return NotFound(f"There is no {kind} {name}, nor any other. Is a node running?")
    close = get_close_matches(name, names, n=1, cutoff=0.5)
    hint = f" Did you mean {close[0]}?" if close else ""
    return NotFound(f"There is no {kind} {name}.{hint} There is: {', '.join(names)}")


def absolute(name: str) -> str:
    """Return a node or topic name with its leading slash."""
    return "/" + name.strip("/")


def node_list(*, hidden: bool = False, domain: int | None = None) -> NodeList:
    """Return all nodes' fully qualified names, sorted."""
    with discovery_node(domain) as node:
        wait_for_graph(node)
        return NodeList(_nodes(node, hidden))


def node_info(name: str, *, hidden: bool = False, domain: int | None = None) -> NodeInfo:
    """Return a node's topics and services. Raise NotFound if there is no such node."""
    name = absolute(name)
    namespace, _, base = name.rpartition("/")
    with discovery_node(domain) as node:
        wait_for_graph(node)
        if name not in _nodes(node, hidden=True):
            raise not_found("node", name, _nodes(node, hidden))

        def pairs(ask: Callable[..., Any]) -> tuple[tuple[str, str], ...]:
            found = sorted(ask(base, namespace or "/"))
            return tuple((topic, kind) for topic, kinds in found for kind in kinds if shown(topic))

        def shown(topic: str) -> bool:
            return hidden or not (_is_hidden_topic(topic) or topic.rpartition("/")[2] in _NODE_SERVICES)

        return NodeInfo(
            name,
            pairs(node.get_publisher_names_and_types_by_node),
            pairs(node.get_subscriber_names_and_types_by_node),
            pairs(node.get_service_names_and_types_by_node),
            pairs(node.get_client_names_and_types_by_node),
        )


def topic_list(types: bool = True, *, hidden: bool = False, domain: int | None = None) -> TopicList:
    """Return all topics, with types and numbers of publishers and subscriptions. `types=False`: display names only."""
    with discovery_node(domain) as node:
        wait_for_graph(node)
        found = TopicList(topics_seen(node, hidden))
        found.with_types = types
        return found


def topics_seen(node: Node, hidden: bool = False) -> list[TopicSummary]:
    """Return the topics that `node` has discovered, without those that only `node` itself uses."""
    topics = []
    for name, kinds in _topics(node, hidden).items():
        publishers, subscribers = _publishers(node, name, hidden), _subscribers(node, name, hidden)
        if publishers or subscribers:
            topics.append(TopicSummary(name, kinds, len(publishers), len(subscribers)))
    return topics


def topic_info(topic: str, *, hidden: bool = False, domain: int | None = None) -> TopicInfo:
    """Return a topic's publishers and subscriptions, QoS, and incompatible pairs.

    Raise NotFound if the topic has neither a publisher nor a subscription.
    """
    topic = absolute(topic)
    with discovery_node(domain) as node:
        wait_for_graph(node)
        publishers, subscribers = _publishers(node, topic, hidden), _subscribers(node, topic, hidden)
        if not publishers and not subscribers:
            raise not_found("topic", topic, _topics(node, hidden))
        return TopicInfo(
            topic,
            _topics(node, hidden=True).get(topic, ()),
            tuple(map(_endpoint, publishers)),
            tuple(map(_endpoint, subscribers)),
            tuple(one.reason for one in _broken(topic, publishers, subscribers)),
        )


def _broken(topic: str, publishers: list[Any], subscribers: list[Any]) -> Iterable[Broken]:
    for publisher in publishers:
        for subscriber in subscribers:
            writer, reader = _endpoint(publisher), _endpoint(subscriber)
            if writer.type != reader.type:
                reason = f"{reader.node} expects {reader.type}, but {writer.node} publishes {writer.type}."
                yield Broken(topic, writer.node, reader.node, reason)
                continue
            verdict, _ = qos_check_compatible(publisher.qos_profile, subscriber.qos_profile)
            if verdict == QoSCompatibility.ERROR:
                reason = f"{reader.node} does not hear {writer.node}: {_clash(writer, reader)}."
                yield Broken(topic, writer.node, reader.node, reason)


def _clash(writer: Endpoint, reader: Endpoint) -> str:
    if (writer.reliability, reader.reliability) == ("best effort", "reliable"):
        return "it asks for reliable and gets best effort"
    if (writer.durability, reader.durability) == ("volatile", "transient local"):
        return "it asks for transient local and gets volatile"
    return f"it asks for a deadline of {reader.deadline} and gets {writer.deadline}, or more than is offered"


def graph(*, hidden: bool = False, domain: int | None = None) -> Graph:
    """Return the whole graph: nodes, topics, and the arrows between them."""
    with discovery_node(domain) as node:
        wait_for_graph(node)
        return graph_seen(node, hidden)


def graph_seen(node: Node, hidden: bool = False) -> Graph:
    """Return the graph as `node` has discovered it, without `node` itself."""
    edges = []
    for name in _topics(node, hidden):
        for role, infos in (("publishes", _publishers), ("subscribes", _subscribers)):
            edges += [Edge(_endpoint(info).node, role, name) for info in infos(node, name, hidden)]
    used = {edge.topic for edge in edges}
    topics = {name: kinds for name, kinds in _topics(node, hidden).items() if name in used}
    broken = [
        pair
        for name in topics
        for pair in _broken(name, _publishers(node, name, hidden), _subscribers(node, name, hidden))
    ]
    return Graph(tuple(_nodes(node, hidden)), topics, tuple(sorted(edges)), tuple(sorted(broken)))
