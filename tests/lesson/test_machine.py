"""Recordings of a running rclpy: the notes about live nodes agree with what the nodes themselves received."""

import time
from collections.abc import Iterator

import pytest
import rclpy
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from std_msgs.msg import Int32

from lesson_nodes import blink_and_beep, heart_and_question
from workbook.lesson.machine import film_of, record_machine, watch_machine
from workbook.recording.machine import MachineRecording
from workbook.ros.domains import lease_domain

ARRIVES_WITHIN_S = 20.0


class Reader(Node):
    """Stores the numbers that its callback receives."""

    def __init__(self, context: Context, depth: int) -> None:
        super().__init__("reader", context=context)
        self.numbers: list[int] = []
        self.create_subscription(Int32, "/numbers", self.on_number, depth)

    def on_number(self, message: Int32) -> None:
        self.numbers.append(message.data)


@pytest.fixture
def context() -> Iterator[Context]:
    with lease_domain() as lease:
        made = Context()
        rclpy.init(context=made, domain_id=lease.domain_id)
        try:
            yield made
        finally:
            rclpy.try_shutdown(context=made)


def await_until(is_so: object) -> None:
    deadline = time.monotonic() + ARRIVES_WITHIN_S
    while not is_so():  # type: ignore[operator]
        assert time.monotonic() < deadline
        time.sleep(0.005)


def test_what_the_queue_threw_away_is_what_the_callback_did_not_get(context: Context) -> None:
    reader = Reader(context, depth=3)
    publisher = Node("writer", context=context).create_publisher(Int32, "/numbers", 100)
    await_until(lambda: publisher.get_subscription_count() == 1)
    with watch_machine(reader) as seen:
        for number in range(1, 9):
            publisher.publish(Int32(data=number))
        time.sleep(0.1)  # like a program that doesn't spin
        executor = SingleThreadedExecutor(context=context)
        executor.add_node(reader)
        while len(reader.numbers) < 3:
            executor.spin_once(timeout_sec=ARRIVES_WITHIN_S)
        executor.shutdown()
    recording = seen.recording
    assert recording is not None
    assert reader.numbers == [6, 7, 8]
    assert [call.number for call in recording.calls] == [6, 7, 8]
    assert [one.number for one in recording.lost(0, recording.seconds)] == [1, 2, 3, 4, 5]
    assert all(one.came <= one.taken for one in recording.items if one.taken is not None)
    assert not recording.spins(recording.items[-1].came + 0.01)
    assert recording.spins(recording.calls[0].begin)
    assert film_of(seen, "numbers").description == "numbers"


def test_nothing_is_left_between_rclpy_and_its_executors(context: Context) -> None:
    from rclpy.executors import Executor

    before = Executor._take_timer, Executor._take_subscription, Executor.wait_for_ready_callbacks
    reader = Reader(context, depth=3)
    with watch_machine(reader):
        assert Executor._take_timer is not before[0]
    assert (Executor._take_timer, Executor._take_subscription, Executor.wait_for_ready_callbacks) == before
    assert [
        name for name, _ in reader.get_node_names_and_namespaces() if name.startswith("_workbook_machine")
    ] == []


def busiest(recording: MachineRecording, name: str) -> tuple[float, float]:
    """Return when the longest call of a callback began and ended."""
    place = next(n for n, source in enumerate(recording.sources) if source.callback == name)
    call = max((one for one in recording.calls if one.source == place), key=lambda one: one.end - one.begin)
    return call.begin, call.end


def test_a_busy_callback_makes_a_timer_miss_ticks() -> None:
    recording = record_machine(blink_and_beep, 2.5, blink_period_s=0.2, beep_period_s=1.0, beep_takes_s=0.9)
    begin, end = busiest(recording, "beep")
    blink = next(n for n, source in enumerate(recording.sources) if source.callback == "blink")
    inside = [one for one in recording.lost(blink, end) if one.came > begin]
    assert len(inside) >= 2
    assert not any(begin < call.begin < end for call in recording.calls if call.source == blink)
    assert not recording.looks((begin + end) / 2)


def test_in_a_deadlock_the_response_waits_in_the_queue() -> None:
    recording = record_machine(heart_and_question, 1.5, way="call", group="default", threads=1)
    client = next(n for n, source in enumerate(recording.sources) if source.kind == "client")
    assert [one.number for one in recording.waiting(client, recording.seconds)] == [1]
    [stuck] = recording.running(recording.seconds - 0.001)
    assert recording.sources[stuck.source].callback == "ask_by_call"
