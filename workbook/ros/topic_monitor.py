"""Monitor a topic: its messages (`topic_echo`) and their rate (`topic_hz`)."""

import itertools
import statistics
import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy

from workbook.ros import fresh_nodes, tools
from workbook.ros.discovery import NODE_UNKNOWN, discovery_node, wait_for_graph
from workbook.ros.messages import message_class
from workbook.ros.session import serving
from workbook.ros.tables import Shown, Table

OnSilence = Callable[[Sequence[str]], None]
_CLOCK = "/clock"
_SILENT_S = 1.0
"""If no message arrives on a published topic for this long (s), its publisher may be waiting for /clock."""
_QUEUE = 100
"""The subscription's queue depth: enough for a second of messages at 100 Hz while a cell draws."""
_POLL_S = 0.02
_LONGEST_LIST = 32
"""The most elements of a list that are shown. More would bury the message's other fields."""


@dataclass(frozen=True, repr=False)
class Echo:
    """A topic's messages in the order of arrival. `times`: each message's arrival time (s since the first message)."""

    topic: str
    type: str
    messages: tuple[Any, ...]
    times: tuple[float, ...]
    waited: float
    held: tuple[str, ...] = ()
    """The topic's publishing nodes that wait for /clock."""

    def __str__(self) -> str:
        if not self.messages:
            return " ".join(
                [f"No message on {self.topic} within {self.waited:g} s.", *clock_notes(self.held)]
            )
        return "\n---\n".join(message_text(message) for message in self.messages)

    def __repr__(self) -> str:
        return str(self)


@dataclass(frozen=True, repr=False)
class Rate(Shown):
    """A topic's rate: the number of messages in `seconds` s, the mean rate (Hz), and the shortest and longest gap (s).

    The rate and the gaps are None if fewer than two messages arrived.
    """

    topic: str
    count: int
    seconds: float
    mean_hz: float | None
    shortest_gap: float | None
    longest_gap: float | None
    spread: float | None
    held: tuple[str, ...] = ()
    """The topic's publishing nodes that wait for /clock."""

    def line(self) -> str:
        """Describe the mean rate, the number of messages, and the shortest and longest gap on one line."""
        if self.mean_hz is None:
            return f"{self.count or 'no'} message{'' if self.count == 1 else 's'} yet: no rate"
        return (
            f"{self.mean_hz:.2f} Hz, from {self.count} messages, "
            f"gaps of {self.shortest_gap:.3f} to {self.longest_gap:.3f} s"
        )

    def _notes(self) -> list[str]:
        return clock_notes(self.held)

    def _tables(self) -> list[Table]:
        header = ("mean rate", "messages", "shortest gap", "longest gap", "spread")
        empty = f"{self.count or 'no'} message{'' if self.count == 1 else 's'} in {self.seconds:g} s: no rate"
        rows: tuple[tuple[str, ...], ...] = ()
        if self.mean_hz is not None:
            gaps = [
                f"{gap:.3f} s"
                for gap in (self.shortest_gap, self.longest_gap, self.spread)
                if gap is not None
            ]
            rows = ((f"{self.mean_hz:.2f} Hz", str(self.count), *gaps),)
        return [Table(f"Rate of {self.topic}", header, rows, empty)]


def clock_notes(held: Iterable[str]) -> list[str]:
    """Return sentences for each node that waits for /clock: why it doesn't publish, and what to do."""
    return [
        f"{node} uses simulated time (use_sim_time), but no node publishes {_CLOCK}. So its timers wait. "
        "Start it without use_sim_time."
        for node in held
    ]


def _held_by_the_clock(node: Node, topic: str) -> tuple[str, ...]:
    """Return the nodes that publish a topic and wait for /clock, which no node publishes."""
    if node.count_publishers(_CLOCK):
        return ()
    writers, followers = (
        {tools.fully_qualified_name(info.node_name, info.node_namespace) for info in infos}
        for infos in (node.get_publishers_info_by_topic(topic), node.get_subscriptions_info_by_topic(_CLOCK))
    )
    return tuple(sorted(one for one in writers & followers if NODE_UNKNOWN not in one))


def message_text(value: Any, indent: str = "") -> str:
    """Format a message as indented `field: value` lines. Long lists are cut."""
    lines = []
    for name in value.get_fields_and_field_types():
        item = getattr(value, name)
        if hasattr(item, "get_fields_and_field_types"):
            lines += [f"{indent}{name}:", message_text(item, indent + "  ")]
        elif _is_list_of_messages(item):
            lines.append(f"{indent}{name}:" if len(item) else f"{indent}{name}: []")
            for part in item[:_LONGEST_LIST]:
                first, *rest = message_text(part, indent + "  ").splitlines()
                lines += [f"{indent}- {first.strip()}", *rest]
            if len(item) > _LONGEST_LIST:
                lines.append(f"{indent}… {len(item)} in all")
        else:
            lines.append(f"{indent}{name}: {_value_text(item)}")
    return "\n".join(lines)


def _is_list_of_messages(item: Any) -> bool:
    return isinstance(item, (list, tuple)) and any(
        hasattr(part, "get_fields_and_field_types") for part in item
    )


def _value_text(item: Any) -> str:
    if isinstance(item, str):
        return item if item and "\n" not in item else repr(item)
    if isinstance(item, (bool, int, float)):
        return str(item)
    values = [part if isinstance(part, (str, bool)) else _number(part) for part in list(item[:_LONGEST_LIST])]
    rest = f", … {len(item)} in all" if len(item) > _LONGEST_LIST else ""
    return f"[{', '.join(map(str, values))}{rest}]"


def _number(part: Any) -> Any:
    return part.item() if hasattr(part, "item") else part


def _matching_qos(node: Node, topic: str) -> QoSProfile:
    """Return a QoS that's compatible with all of the topic's publishers: transient local if all of them offer that."""
    offered = [info.qos_profile for info in node.get_publishers_info_by_topic(topic)]
    reliable = bool(offered) and all(qos.reliability == ReliabilityPolicy.RELIABLE for qos in offered)
    keeps = bool(offered) and all(qos.durability == DurabilityPolicy.TRANSIENT_LOCAL for qos in offered)
    return QoSProfile(
        depth=_QUEUE,
        reliability=ReliabilityPolicy.RELIABLE if reliable else ReliabilityPolicy.BEST_EFFORT,
        durability=DurabilityPolicy.TRANSIENT_LOCAL if keeps else DurabilityPolicy.VOLATILE,
    )


@dataclass(frozen=True)
class _Source:
    """A topic, its domain, and the nodes to run while messages are collected.

    `domain`: None for this notebook's. `nodes`: None for all nodes made with `fresh`.
    """

    topic: str
    domain: int | None
    nodes: Iterable[Node] | None


class _Heard(NamedTuple):
    """A topic's type and its (time, message) pairs in order.

    `held`: if no message arrived, the topic's publishing nodes that wait for /clock.
    """

    type: str
    arrivals: list[tuple[float, Any]]
    held: tuple[str, ...]


def _collect(
    source: _Source,
    timeout: float,
    *,
    raw: bool,
    enough: Callable[[list[tuple[float, Any]]], bool],
    on_arrival: Callable[[Any], None] = lambda message: None,
    on_silence: OnSilence | None = None,
    on_held: OnSilence = lambda nodes: None,
) -> _Heard:
    """Collect a topic's (time, message) pairs until `enough` returns True or `timeout` s have passed."""
    topic = tools.absolute(source.topic)
    arrivals: list[tuple[float, Any]] = []

    def arrived(message: Any) -> None:
        arrivals.append((time.monotonic(), message))
        on_arrival(message)

    with discovery_node(source.domain) as node:
        partners = fresh_nodes.nodes_in(node.context) if source.nodes is None else list(source.nodes)
        partners = [partner for partner in partners if partner.executor is None]
        if on_silence is not None:
            wait_for_graph(node)
            if not node.get_publishers_info_by_topic(topic):
                on_silence(_published(node))
        began = time.monotonic()
        end = began + timeout
        type_name, held = "", tuple[str, ...]()
        with serving(node, *partners) as executor:
            while not enough(arrivals) and (left := end - time.monotonic()) > 0:
                if not type_name:
                    infos = node.get_publishers_info_by_topic(topic)
                    type_name = infos[0].topic_type if infos else ""
                    if type_name:
                        kind, qos = message_class(type_name), _matching_qos(node, topic)
                        node.create_subscription(kind, topic, arrived, qos, raw=raw)
                if not arrivals and not held and time.monotonic() - began > _SILENT_S:
                    held = _held_by_the_clock(node, topic)
                    if held:
                        on_held(held)
                executor.step(min(_POLL_S, left))
        if not type_name:
            raise tools.not_found("published topic", topic, _published(node))
    return _Heard(type_name, arrivals, () if arrivals else held)


def _published(node: Node) -> list[str]:
    return [entry.name for entry in tools.topics_seen(node) if entry.publishers]


def topic_echo(
    topic: str,
    count: int | None = 3,
    timeout: float = 5.0,
    *,
    nodes: Iterable[Node] | None = None,
    domain: int | None = None,
    on_message: Callable[[Any], None] = lambda message: None,
    on_silence: OnSilence | None = None,
    on_held: OnSilence = lambda nodes: None,
) -> Echo:
    """Receive up to `count` messages on a topic (None: all of them), for at most `timeout` s.

    In the meantime, the nodes made with `fresh` run (or those in `nodes`). `on_silence`: called once with the published
    topics if no node publishes this topic at first. `on_held`: called once with the topic's publishing nodes if they
    wait for /clock. Raise NotFound if no node has published the topic by the end.
    """

    def enough(arrivals: list[tuple[float, Any]]) -> bool:
        return count is not None and len(arrivals) >= count

    source = _Source(topic, domain, nodes)
    heard = _collect(
        source,
        timeout,
        raw=False,
        enough=enough,
        on_arrival=on_message,
        on_silence=on_silence,
        on_held=on_held,
    )
    times, messages = zip(*heard.arrivals, strict=True) if heard.arrivals else ((), ())
    moments = tuple(moment - times[0] for moment in times)
    return Echo(tools.absolute(topic), heard.type, messages, moments, timeout, heard.held)


def topic_hz(
    topic: str,
    seconds: float = 5.0,
    *,
    nodes: Iterable[Node] | None = None,
    domain: int | None = None,
    on_silence: OnSilence | None = None,
    on_held: OnSilence = lambda nodes: None,
    on_look: Callable[[Sequence[float]], None] = lambda times: None,
) -> Rate:
    """Measure the rate of messages on a topic over `seconds` s, beginning with the first one.

    In the meantime, the nodes made with `fresh` run (or those in `nodes`). `on_silence`, `on_held`: see `topic_echo`.
    `on_look`: called repeatedly with the arrival times (s) of all messages so far. Raise NotFound if no node publishes
    the topic.
    """
    times: list[float] = []

    def enough(arrivals: list[tuple[float, Any]]) -> bool:
        times.extend(moment for moment, _ in arrivals[len(times) :])
        on_look(times)
        return bool(times) and time.monotonic() - times[0] >= seconds

    source = _Source(topic, domain, nodes)
    heard = _collect(
        source, 2 * seconds + 1.0, raw=True, enough=enough, on_silence=on_silence, on_held=on_held
    )
    rate = rate_of(tools.absolute(topic), [moment for moment, _ in heard.arrivals], seconds)
    return replace(rate, held=heard.held)


def rate_of(topic: str, times: Sequence[float], seconds: float) -> Rate:
    """Compute the rate from the arrival `times` (s) of messages during `seconds` s."""
    gaps = [later - earlier for earlier, later in itertools.pairwise(times)]
    if not gaps:
        return Rate(topic, len(times), seconds, None, None, None, None)
    mean = len(gaps) / (times[-1] - times[0])
    return Rate(topic, len(times), seconds, mean, min(gaps), max(gaps), statistics.pstdev(gaps))
