"""What the panel learns about a domain, and that the domain doesn't notice the panel."""

import json
import math
import os
import select
import signal
import socket
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any, ClassVar

import pytest
from std_msgs.msg import Float32MultiArray, String

from tests.ros.panel_watcher import Watcher
from workbook.inside import RUN, tap
from workbook.lab.panel import observer
from workbook.lab.panel.traffic import NUMBERS_KEPT, PublishedMessage, Traffic, Wire, one_line

ENDS = """
import os, subprocess
child = subprocess.Popen({command}, stdin=subprocess.PIPE)
print(child.pid, flush=True)
input()
"""
ANGLE = 0.125
"""A number that float32 represents exactly."""
COUNTS = "print(pub.get_subscription_count(), *node_list(), *talker.get_node_names())"


@pytest.fixture
def watcher() -> Iterator[Watcher]:
    one = Watcher()
    yield one
    if one.process.poll() is None:
        assert one.close() == 0


def domain_of(kernel: Any) -> int:
    return int(kernel.good("import os; print(os.environ['ROS_DOMAIN_ID'])").text)


def report(count: int = 1, moment: float = 0.0) -> PublishedMessage:
    return PublishedMessage("/chatter", "std_msgs/msg/String", count, moment, 0, b"")


def test_it_tells_the_graph_the_values_and_the_messages(kernel: Any, watcher: Watcher) -> None:
    kernel.good("init(); talker = fresh(Talker); pub = talker.pub")
    watcher.order(domain=domain_of(kernel))
    graph = watcher.wait("graph", lambda one: one["topics"])
    assert graph["nodes"] == ["/talker"] and graph["listening"]
    assert graph["topics"] == [
        {
            "name": "/chatter",
            "type": "std_msgs/msg/String",
            "publishers": ["/talker"],
            "subscribers": ["/talker"],
        }
    ]
    watcher.order(echo="/chatter")
    kernel.good("spin_for(talker, seconds=3)")
    news = watcher.wait("news", lambda one: "Hz" in one["topics"].get("/chatter", {}).get("rate", ""))
    assert news["topics"]["/chatter"]["value"].startswith("tick ")
    assert any(
        text.startswith("data: tick ")
        for text in watcher.wait("news", lambda one: one["messages"])["messages"]
    )
    watcher.wait("news", lambda one: one["topics"]["/chatter"]["rate"] == "silent now")


def test_the_graph_of_a_lesson_does_not_know_it(kernel: Any, watcher: Watcher) -> None:
    kernel.good("from workbook.ros import node_list, topic_info; init()")
    kernel.good("talker = fresh(Node, 'talker'); pub = talker.create_publisher(String, 'chatter', 10)")
    watcher.order(domain=domain_of(kernel))
    watcher.order(echo="/chatter")
    watcher.wait("graph", lambda one: one["nodes"] == ["/talker"])
    kernel.good("pub.publish(String(data='nobody subscribes'))")
    watcher.wait("news", lambda one: one["messages"] == ["data: nobody subscribes"])
    seen = kernel.good(COUNTS).text.split()
    assert seen[:2] == ["0", "/talker"]
    assert all(name.startswith("_workbook_") for name in seen[2:] if name != "talker"), seen
    told = kernel.good(
        "print(topic_info('/chatter').subscribers, len(talker.get_topic_names_and_types()))"
    ).text
    watcher.close()
    assert (
        told
        == kernel.good(
            "print(topic_info('/chatter').subscribers, len(talker.get_topic_names_and_types()))"
        ).text
    )


def test_it_changes_to_another_domain(open_kernel: Any, watcher: Watcher) -> None:
    for name in ("one", "other"):
        kernel = open_kernel(name)
        kernel.good(f"init(); node = fresh(Node, 'node_{name}')")
        watcher.order(domain=domain_of(kernel))
        watcher.wait("graph", lambda told, name=name: told["nodes"] == [f"/node_{name}"])
    watcher.order(domain=None)
    assert watcher.close() == 0


class GraphWithLeftOvers:
    """Stands in for a node that joins the domain. `seen`: what each new one sees; (name, has endpoints) by node."""

    seen: ClassVar[list[dict[str, bool]]] = []
    joined = 0

    def __init__(self, domain_id: int) -> None:
        self._nodes = self.seen[min(type(self).joined, len(self.seen) - 1)]
        type(self).joined += 1

    def graph(self) -> dict[str, Any]:
        return {"nodes": sorted(self._nodes), "topics": []}

    def has_endpoints(self, name: str) -> bool:
        return self._nodes[name]

    def close(self) -> None:
        pass


@pytest.mark.parametrize(
    ("seen", "joined", "nodes"),
    [
        ([{"/gone": False, "/talker": True}, {"/talker": True}], 2, ["/talker"]),
        ([{"/gone": False}, {}], 2, []),
        ([{"/bare": False}], 2, ["/bare"]),  # it's real: the second node sees it as well
        ([{"/talker": True}], 1, ["/talker"]),
    ],
)
def test_a_node_that_was_announced_after_it_left_does_not_stay(
    seen: list[dict[str, bool]],
    joined: int,
    nodes: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    graphs = type("Graphs", (GraphWithLeftOvers,), {"seen": seen, "joined": 0})
    monkeypatch.setattr(observer, "HiddenNode", graphs)
    monkeypatch.setattr(observer, "Wire", lambda domain_id: SimpleNamespace(open=lambda: True))
    watch = observer.DomainWatch(17)
    for turn in range(8):
        watch.work(turn * 2 * observer.GRAPH_EVERY_S)
    told = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert graphs.joined == joined
    assert [one["nodes"] for one in told if one["kind"] == "graph"][-1] == nodes
    assert [one["awake"] for one in told if "awake" in one][-1] == bool(nodes)


def test_it_ends_with_its_parent() -> None:
    command = [sys.executable, "-P", "-m", "workbook.lab.panel.observer"]
    code = ENDS.format(command=f"{command!r} + [str(os.getpid())]")
    parent = subprocess.Popen(
        [sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    )
    assert parent.stdout is not None and parent.stdin is not None
    observer = os.pidfd_open(int(parent.stdout.readline()))
    parent.kill()
    parent.wait()
    try:
        assert select.select([observer], [], [], 20.0)[0], "the observer outlives its parent"
    finally:
        os.close(observer)
        parent.stdin.close()
        parent.stdout.close()


class FakePublisher:
    """The part of a publisher that the tap uses."""

    def __init__(self, topic: str, kind: type = String) -> None:
        self.topic_name, self.msg_type = topic, kind


def test_the_robot_sleeps_when_its_publisher_is_gone(kernel: Any, watcher: Watcher) -> None:
    domain_id = domain_of(kernel)
    kernel.good("from std_msgs.msg import Float32MultiArray; init(); node = fresh(Node, 'arm')")
    kernel.good("pub = node.create_publisher(Float32MultiArray, '/robot/joint_positions', 10)")
    watcher.order(domain=domain_id)
    watcher.wait("graph", lambda one: one["nodes"] == ["/arm"] and one["topics"])
    kernel.good("pub.publish(Float32MultiArray(data=[0.125] * 12))")
    watcher.wait("robot", lambda one: "posed by" in one.get("text", "") and one["pose"] == [ANGLE] * 12)
    kernel.good("node.destroy_node()")
    watcher.wait("robot", lambda one: one.get("text", "").endswith("asleep") and one["pose"] is None)
    late = FakePublisher("/robot/joint_positions", Float32MultiArray)
    tap.Tap(domain_id).published(late, Float32MultiArray(data=[0.2] * 12))
    watcher.wait("robot", lambda one: "posed by" in one.get("text", ""))
    watcher.wait("robot", lambda one: one.get("text", "").endswith("asleep"))


def test_a_flood_is_counted_and_reported_in_part() -> None:
    wire = Wire(230)
    assert wire.open() and not Wire(230).open()
    reporting = tap.Tap(230)
    publisher = FakePublisher("/flood")
    try:
        for _ in range(1000):
            reporting.published(publisher, b"\0" * 12)
        reports = wire.reports()
        assert len(reports) < 200 and reports[0].type_name == "std_msgs/msg/String"
        publisher.__dict__["_workbook_tap"].allowance = 1.0
        reporting.published(publisher, b"\0" * (tap.LONGEST + 1))
        (last,) = wire.reports()
        assert sum(one.number for one in (*reports, last)) == 1001
        assert last.data == b"" and last.size == tap.LONGEST + 1
    finally:
        wire.close()
    reporting.published(publisher, b"nobody listens")


def test_garbage_on_the_wire_is_left_out() -> None:
    wire = Wire(231)
    assert wire.open()
    with socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM) as stranger:
        for garbage in (b"", b"{}", b"[1]\n", b"[1,2,null,4,5]\n", b"\xff\xff\n\0"):
            stranger.sendto(garbage, tap.ADDRESS.format(231))
        good = b'["/chatter", "std_msgs/msg/String", 1, 2.5, 0]\n'
        stranger.sendto(good, tap.ADDRESS.format(231))
    assert wire.reports() == [report(1, 2.5)]
    wire.close()


def test_a_program_that_fails_in_publish_shows_its_own_frames_only(tmp_path: Path) -> None:
    program = tmp_path / "program.py"
    program.write_text(
        "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\n"
        "rclpy.init()\nNode('n').create_publisher(String, 'c', 1).publish('text')\n"
    )
    logs = []
    for options in ([], ["--tap", "229"]):
        done = subprocess.run(
            [sys.executable, "-P", str(RUN), "host", *options, str(program)], capture_output=True, text=True
        )
        logs.append(done.stderr)
    assert logs[0] == logs[1] and "Expected <class" in logs[0]


@pytest.mark.parametrize(
    ("moments", "now", "words"),
    [
        ([0.0], 0.2, "once"),
        ([0.0, 0.001, 0.002], 5.0, "3 messages"),
        ([0.05 * n for n in range(60)], 3.0, "20 Hz"),
        ([0.001 * n for n in range(2000)], 2.0, "1000 Hz"),
        ([0.0, 2.0, 4.0], 5.0, "0.5 Hz"),
        ([0.0, 2.0, 4.0], 9.5, "silent now"),
    ],
)
def test_a_rate_in_words(moments: list[float], now: float, words: str) -> None:
    traffic = Traffic()
    for moment in moments:
        traffic.add(report(moment=moment), "data: x")
    assert traffic.rate(now) == words


def test_the_numbers_of_a_topic_are_kept_for_a_sparkline() -> None:
    traffic = Traffic()
    for value in (0.5, math.nan, 1 / 3, True, "word", *range(NUMBERS_KEPT)):
        traffic.add(report(), f"data: {value}", SimpleNamespace(data=value))
        assert ("numbers" in traffic.news(0.0)) is (len(traffic.numbers) > 1)
    told = traffic.news(0.0)
    assert told["numbers"] == [float(one) for one in range(NUMBERS_KEPT)]
    assert told["reacts"] is False, "no robot shows /chatter"
    battery = Traffic()
    for value in (0.5, 1 / 3):
        battery.add(
            PublishedMessage("/robot/battery", "std_msgs/msg/Float32", 1, 0.0, 0, b""),
            "",
            SimpleNamespace(data=value),
        )
    assert battery.news(0.0) == {"rate": "2 messages", "value": "", "numbers": [0.5, 0.3333], "reacts": True}


def test_a_response_is_reported_and_is_no_topic(kernel: Any, watcher: Watcher) -> None:
    kernel.good("from std_srvs.srv import Trigger; init(); node = fresh(Node, 'self_test')")
    kernel.good(
        "def answer(request, response):\n"
        "    response.success, response.message = False, 'the left knee is stiff'\n"
        "    return response\n"
        "node.create_service(Trigger, '/robot/self_test', answer)\n"
        "client = node.create_client(Trigger, '/robot/self_test')"
    )
    watcher.order(domain=domain_of(kernel))
    watcher.wait("graph", lambda one: one["nodes"] == ["/self_test"])
    kernel.good("future = client.call_async(Trigger.Request())\nspin_for(node, seconds=1)")
    # Words are sent at most a few times a second, so they may come after the shake and disappear again soon.
    watcher.heard("robot", lambda one: one.get("shake"))
    words = "self_test: success: False, message: the left knee is stiff"
    watcher.heard("robot", lambda one: one.get("words") == words)
    assert kernel.good("print(future.result().message)").text == "the left knee is stiff\n"
    assert not [one for one in watcher.told if one["kind"] == "news" and one["topics"]]


@pytest.mark.parametrize(
    ("text", "line"),
    [
        ("data: operational", "operational"),
        ("layout:\n  dim: []\n  data_offset: 0\ndata: [0.12345678, 1.0, 1.5e-05]", "[0.123, 1.0, 1.5e-05]"),
        ("x: 1.0\ny: 2.0", "x: 1.0, y: 2.0"),
        ("linear:\n  x: 1.0\n  y: 2.0\nangular:\n  z: 0.0", "linear: x: 1.0, y: 2.0, angular: z: 0.0"),
        (
            "header:\n  stamp:\n    sec: 3\n    nanosec: 5\n  frame_id: 'a'\nposition: [1.0]",
            "position: [1.0]",
        ),
        ("data: " + "a" * 200, "a" * 89 + "…"),
    ],
)
def test_a_message_in_a_line(text: str, line: str) -> None:
    assert one_line(text) == line


def test_the_signal_of_a_terminal_ends_it(watcher: Watcher) -> None:
    watcher.order(domain=None)
    watcher.process.send_signal(signal.SIGTERM)
    assert watcher.process.wait(20) == -signal.SIGTERM
    watcher.process.stdin.close()  # type: ignore[union-attr]
    watcher.process.stdout.close()  # type: ignore[union-attr]
