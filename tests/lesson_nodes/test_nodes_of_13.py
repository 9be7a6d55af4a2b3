"""The nodes of lesson 13: a heartbeat with gaps, a robot that publishes early, and a newcomer's first messages."""

import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
import rclpy
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

from lesson_nodes import heartbeat
from lesson_nodes.first_words import WORDS, FirstWords
from lesson_nodes.heartbeat import BEAT_QOS, STATUS_QOS, Heartbeat
from tests.lesson_nodes.ending import ended_in_order
from workbook.lesson import arrivals, record, values
from workbook.ros.domains import lease_domain
from workbook.ros.environment import child_environment, prepare

ROOT = Path(__file__).resolve().parents[2]
PATIENCE_S = 30.0
BEAT = "/robot/heartbeat"
KEPT = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.fixture
def domain() -> Iterator[int]:
    with lease_domain() as lease:
        prepare(domain_id=lease.domain_id)
        rclpy.init(domain_id=lease.domain_id, signal_handler_options=rclpy.signals.SignalHandlerOptions.NO)
        try:
            yield lease.domain_id
        finally:
            rclpy.shutdown()


class Listener(Node):
    """Stores the texts of one topic."""

    def __init__(self, topic: str, qos: QoSProfile) -> None:
        super().__init__("listener")
        self.heard: list[str] = []
        self.create_subscription(String, topic, self.on_word, qos)

    def on_word(self, message: String) -> None:
        self.heard.append(message.data)


def spin_until(node: Node, done: Callable[[], bool]) -> None:
    executor = SingleThreadedExecutor()
    executor.add_node(node)
    turns = iter(range(int(PATIENCE_S / 0.05)))
    while not done():
        assert next(turns, None) is not None, "it did not get there in time"
        executor.spin_once(timeout_sec=0.05)
    executor.shutdown()


def heard_so_many(listener: Listener, words: int) -> bool:
    return len(listener.heard) >= words


def program(name: str, domain_id: int, **parameters: Any) -> "subprocess.Popen[str]":
    options = [item for key, value in parameters.items() for item in ("-p", f"{key}:={value}")]
    return subprocess.Popen(
        [sys.executable, "-m", f"lesson_nodes.{name}", *(["--ros-args", *options] if options else [])],
        cwd=ROOT,
        env=child_environment(domain_id),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )


def test_the_heart_beats_four_times_a_second_and_pauses() -> None:
    recording = record(heartbeat, {BEAT: 0.25}, seconds=20, beats_for_s=2.0, silent_for_s=3.0)
    assert values(recording, BEAT) == [
        f"beat {number + 1}" for number in range(len(arrivals(recording, BEAT)))
    ]
    gaps = [round(b - a, 2) for a, b in pairwise(arrivals(recording, BEAT))]
    assert set(gaps) == {0.25, 3.25}
    assert gaps.index(3.25) == 7
    (beat,) = recording.topic(BEAT).publishers
    assert (beat.reliability, beat.durability, beat.deadline) == ("best_effort", "volatile", 0.5)


@pytest.mark.parametrize(("beats", "silence"), [(0.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (float("nan"), 0.0)])
def test_times_that_make_no_sense_are_refused(domain: int, beats: float, silence: float) -> None:
    with pytest.raises(ValueError, match="cannot beat"):
        Heartbeat(beats_for_s=beats, silent_for_s=silence)


def test_a_late_listener_has_the_status_at_once(domain: int) -> None:
    robot = Heartbeat()
    late = Listener("/robot/status", STATUS_QOS)
    spin_until(late, lambda: late.heard == ["operational"])
    assert robot.beats == 0
    assert BEAT_QOS.deadline.nanoseconds == 500_000_000


@pytest.mark.parametrize(("depth", "kept"), [(1, ["operational"]), (2, ["standing", "operational"])])
def test_as_many_words_are_kept_as_the_depth_says(domain: int, depth: int, kept: list[str]) -> None:
    robot = program("early_speaker", domain, depth=depth)
    try:
        assert robot.stdout is not None
        assert "has said it all" in robot.stdout.readline()
        late = Listener("/robot/status", KEPT)
        spin_until(late, lambda: len(late.heard) >= depth)
        robot.send_signal(signal.SIGINT)
        log, _ = robot.communicate(timeout=PATIENCE_S)
    finally:
        robot.kill()
        robot.wait()
    assert late.heard == kept
    assert ended_in_order(robot.returncode, log), log


@pytest.mark.parametrize("cure", [{"wait_for": "count"}, {"wait_for": "matched"}, {"latched": True}])
def test_with_each_cure_all_first_words_arrive(domain: int, cure: dict[str, Any]) -> None:
    ears = Listener("/robot/greeting", KEPT if "latched" in cure else QoSProfile(depth=100))
    for number in (1, 2):
        newcomer = program("first_words", domain, **cure)
        out, _ = newcomer.communicate(timeout=PATIENCE_S)
        assert newcomer.returncode == 0, out
        assert float(out) > 0.0
        spin_until(ears, partial(heard_so_many, ears, number * len(WORDS)))
    assert ears.heard == [*WORDS, *WORDS]


def test_control_c_ends_a_newcomer_that_finds_nobody(domain: int) -> None:
    newcomer = program("first_words", domain, wait_for="count")
    here = Node("here")
    try:
        spin_until(here, lambda: here.count_publishers("/robot/greeting") > 0)
        newcomer.send_signal(signal.SIGINT)
        out, _ = newcomer.communicate(timeout=PATIENCE_S)
    finally:
        newcomer.kill()
        newcomer.wait()
    assert ended_in_order(newcomer.returncode, out), out


def test_another_way_to_wait_is_refused(domain: int) -> None:
    with pytest.raises(ValueError, match="nothing, count, matched"):
        FirstWords(wait_for="luck")
