"""Watch the active notebook's ROS domain for the panel, as a child process of JupyterLab's server.

    python -m workbook.lab.panel.observer PARENT

It reads JSON lines, {"domain": 17} and {"echo": "/topic"} (null: none), and writes changes as JSON lines. It exits when
its input closes or its parent process ends. On the domain, it's a hidden node without any topics. The publishing
processes send it copies of their messages (see `workbook.inside.tap`).
"""

import contextlib
import json
import os
import select
import sys
import time
from typing import Any

from workbook.inside.libc import die_with_parent
from workbook.lab.panel.robot import PanelRobot
from workbook.lab.panel.traffic import PublishedMessage, Traffic, Wire, one_line, text_of

GRAPH_EVERY_S = 1.0
NEWS_EVERY_S = 0.25
ROBOT_EVERY_S = 0.05
"""The shortest time (s) between updates of the robot. Between updates, the panel moves the robot smoothly."""
GIVES_WAY = 10
"""The observer's nice value, so that it doesn't distort a lesson's measurements."""


def say(kind: str, **values: object) -> None:
    """Write a line of JSON for the panel."""
    print(json.dumps({"kind": kind, **values}), flush=True)


class HiddenNode:
    """A hidden node that only queries a domain's graph."""

    def __init__(self, domain_id: int) -> None:
        from rclpy.context import Context
        from rclpy.node import Node

        self.context = Context()
        self.context.init(args=[], initialize_logging=False, domain_id=domain_id)
        self.node = Node(
            f"_workbook_panel_{os.getpid()}",
            context=self.context,
            use_global_arguments=False,
            enable_rosout=False,
            start_parameter_services=False,
        )

    def graph(self) -> dict[str, Any]:
        """Return the nodes, and the topics with their types, publishers, and subscribers."""
        from workbook.ros.tools import graph_seen

        seen = graph_seen(self.node)
        topics = [
            {
                "name": name,
                "type": ", ".join(types),
                "publishers": _nodes(seen.edges, name, "publishes"),
                "subscribers": _nodes(seen.edges, name, "subscribes"),
            }
            for name, types in seen.topics.items()
        ]
        return {"nodes": list(seen.nodes), "topics": topics}

    def has_endpoints(self, name: str) -> bool:
        """Return whether a node of the graph publishes or subscribes to any topic, hidden ones included."""
        namespace, _, base = name.rpartition("/")
        ask = (
            self.node.get_publisher_names_and_types_by_node,
            self.node.get_subscriber_names_and_types_by_node,
        )
        with contextlib.suppress(RuntimeError):  # the node has just left the graph
            return any(one(base, namespace or "/") for one in ask)
        return False

    def close(self) -> None:
        """Leave the domain."""
        self.node.destroy_node()
        self.context.try_shutdown()
        self.context.destroy()


def _nodes(edges: Any, topic: str, role: str) -> list[str]:
    return sorted(edge.node for edge in edges if edge.topic == topic and edge.role == role)


class DomainWatch:
    """Collects what the panel shows for one domain."""

    def __init__(self, domain_id: int) -> None:
        self.echo: str | None = None
        self._domain_id = domain_id
        self._place = HiddenNode(domain_id)
        self._bare: set[str] = set()
        self._checked_again: set[str] = set()
        self.wire = Wire(domain_id)
        self._graph: dict[str, Any] = {}
        self._traffic: dict[str, Traffic] = {}
        self._told: object = None
        self._robot = PanelRobot()
        self._due = dict.fromkeys(("graph", "news", "robot"), 0.0)
        self.fresh = self._robot_is_fresh = False

    def take_in(self) -> None:
        """Process the programs' new reports."""
        for report in self.wire.reports():
            message = _message(report)
            text = text_of(report, message)
            if "/srv/" not in report.type_name:
                self._traffic.setdefault(report.topic, Traffic()).add(report, text, message)
            self._robot.take(report.topic, report.type_name, message, one_line(text), time.monotonic())
            self.fresh = self._robot_is_fresh = True

    def work(self, now: float) -> float:
        """Send the panel all updates that are due.

        Return the time (s) until the next one if no report arrives earlier.
        """
        tasks = (
            ("graph", GRAPH_EVERY_S, self._look),
            ("news", NEWS_EVERY_S if self.fresh or self._is_heard() else GRAPH_EVERY_S, self._tell_news),
            ("robot", ROBOT_EVERY_S if self._robot_is_fresh else GRAPH_EVERY_S, self._tell_robot),
        )
        for name, period, task in tasks:
            if now >= self._due[name]:
                task(now)
                self._due[name] = time.monotonic() + period
            self._due[name] = min(self._due[name], now + period)
        return max(0.0, min(self._due.values()) - time.monotonic())

    def _is_heard(self) -> bool:
        return any(one.rate(time.monotonic()) != "silent now" for one in self._traffic.values())

    def _look(self, now: float) -> None:
        listening = self.wire.open()
        graph = self._place.graph() | {"listening": listening}
        if self._has_left_overs(graph["nodes"]):
            return
        if graph != self._graph:
            self._graph = graph
            say("graph", **graph)
        # Do this even if the graph hasn't changed: a last report may arrive after its publisher has left.
        published = {topic["name"]: topic["type"] for topic in graph["topics"] if topic["publishers"]}
        self._robot.look(bool(graph["nodes"]), published, now)
        for topic in set(self._traffic) - {topic["name"] for topic in graph["topics"]}:
            del self._traffic[topic]

    def _has_left_overs(self, nodes: list[str]) -> bool:
        """Return whether the graph seems to contain a node whose process has ended. If so, join the domain again.

        rmw_dds_common adds a node back to the graph, for good, if the node's last announcement arrives after the news
        that its process has left. Such a node has no endpoints; a running rclpy node has at least /parameter_events.
        """
        bare = {name for name in nodes if not self._place.has_endpoints(name)}
        self._checked_again &= bare
        lasting = (bare & self._bare) - self._checked_again
        self._bare = bare
        if lasting:
            self._checked_again |= lasting
            self._place.close()
            self._place = HiddenNode(self._domain_id)
        return bool(lasting)

    def _tell_news(self, now: float) -> None:
        self.fresh = False
        known = {topic["name"] for topic in self._graph.get("topics", ())}
        heard = {name: one for name, one in self._traffic.items() if name in known}
        topics = {name: one.news(now) for name, one in heard.items()}
        echoed = heard.get(self.echo or "")
        messages = list(echoed.messages) if echoed is not None else []
        if (topics, self.echo, messages) != self._told:
            self._told = topics, self.echo, messages
            say("news", topics=topics, echo=self.echo, messages=messages)

    def _tell_robot(self, now: float) -> None:
        self._robot_is_fresh = False
        news = self._robot.news(now)
        if news:
            say("robot", **news)

    def close(self) -> None:
        """Leave the domain."""
        self.wire.close()
        self._place.close()


def _message(report: PublishedMessage) -> Any:
    """Decode a report's message; None if it can't be decoded."""
    from rclpy.serialization import deserialize_message

    from workbook.ros.messages import message_class, service_class

    with contextlib.suppress(Exception):
        of_service = "/srv/" in report.type_name
        kind = service_class(report.type_name).Response if of_service else message_class(report.type_name)
        return deserialize_message(report.data, kind) if report.data else None
    return None


class PanelObserver:
    """Watches the domain and topic that its input names."""

    def __init__(self) -> None:
        self._watch: DomainWatch | None = None
        self._input = b""

    def run(self) -> None:
        """Run until the input ends."""
        os.set_blocking(0, False)
        pause: float | None = None
        while True:
            wire = self._watch.wire.socket if self._watch is not None else None
            sources: list[Any] = [0] if wire is None else [0, wire]
            ready, _, _ = select.select(sources, [], [], pause)
            if 0 in ready and not self._obey():
                break
            if self._watch is not None:
                self._watch.take_in()
            pause = self._watch.work(time.monotonic()) if self._watch is not None else None
        self._follow(None)

    def _obey(self) -> bool:
        chunk = os.read(0, 1 << 16)
        *lines, self._input = (self._input + chunk).split(b"\n")
        for line in lines:
            order = json.loads(line)
            if "domain" in order:
                self._follow(order["domain"])
            if "echo" in order and self._watch is not None:
                self._watch.echo = order["echo"]
                self._watch.fresh = True
        return bool(chunk)

    def _follow(self, domain_id: int | None) -> None:
        if self._watch is not None:
            self._watch.close()
            self._watch = None
        if domain_id is not None:
            self._watch = DomainWatch(domain_id)


if __name__ == "__main__":
    die_with_parent(int(sys.argv[1]))
    os.nice(GIVES_WAY)
    PanelObserver().run()
