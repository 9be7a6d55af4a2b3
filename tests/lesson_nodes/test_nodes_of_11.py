"""The nodes of lesson 11: a hand that is touched, a monitor with a callback, and one that polls."""

import asyncio
import os
from collections.abc import Iterator
from itertools import pairwise

import pytest
from rclpy.node import Node
from std_msgs.msg import Int32

from lesson_nodes import callback_monitor, polling_monitor, touch_sensor
from tests.lesson_nodes.ending import ended_in_order
from workbook.lesson import programs, run, start, stop
from workbook.ros.domains import lease_domain
from workbook.ros.environment import prepare
from workbook.ros.kernel_node import close_kernel_node
from workbook.ros.session import fresh, init, shutdown

TOUCHES = 40


@pytest.fixture(autouse=True)
def domain(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    for name in list(os.environ):
        monkeypatch.setenv(name, os.environ[name])  # restores what `prepare` changes
    with lease_domain() as lease:
        prepare(domain_id=lease.domain_id)
        try:
            yield
        finally:
            stop()
            shutdown()
            close_kernel_node()


class Ear(Node):
    """Subscribes to the hand and both monitors."""

    def __init__(self) -> None:
        super().__init__("ear")
        self.heard: dict[str, list[int]] = {"touch": [], "polling": [], "callback": []}
        for name, topic in (
            ("touch", "/robot/touch"),
            ("polling", "/monitor/by_polling"),
            ("callback", "/monitor/by_callback"),
        ):
            numbers = self.heard[name]
            self.create_subscription(Int32, topic, lambda m, numbers=numbers: numbers.append(m.data), 200)


def match(**polling: object) -> dict[str, list[int]]:
    """Return what arrived when the hand was touched forty times."""
    init()
    ear = fresh(Ear)
    try:
        start(polling_monitor, **polling)
        start(callback_monitor)
        start(touch_sensor, touches=TOUCHES, listeners=3)
        everything = list(range(1, TOUCHES + 1))
        asyncio.run(run(ear, seconds=120, until=lambda: ear.heard["callback"] == everything))
        asyncio.run(run(ear, seconds=0.5))
    finally:
        stop()
    return ear.heard


def test_the_callback_reports_all_and_looking_misses_most() -> None:
    heard = match(poll_s=0.05)
    assert heard["touch"] == list(range(1, TOUCHES + 1))
    assert 5 <= len(heard["polling"]) < TOUCHES / 2
    assert heard["polling"] == sorted(set(heard["polling"]))


def test_looking_at_a_queue_misses_nothing() -> None:
    heard = match(poll_s=0.05, keep_all=True)
    assert heard["polling"] == list(range(1, TOUCHES + 1))


def test_looking_without_a_sleep_works_and_ends_well() -> None:
    init()
    start(polling_monitor, poll_s=0.0)
    monitor = programs._started["polling_monitor"]
    stop()
    ended = monitor.record()
    assert ended_in_order(ended.exit, ended.end_log), ended.end_log


def test_the_plan_of_touches_is_the_same_each_time_and_adds_up() -> None:
    plan = touch_sensor.touch_plan(120)
    assert plan == touch_sensor.touch_plan(120)
    assert sum(at_once for _, at_once in plan) == 120
    assert all(b - a >= touch_sensor.PAUSE_S[0] for (a, _), (b, _) in pairwise(plan))
    assert max(at_once for _, at_once in plan) == max(touch_sensor.AT_ONCE)


def test_impossible_settings_are_refused_in_words() -> None:
    with pytest.raises(ValueError, match="not 0"):
        touch_sensor.touch_plan(0)
    with pytest.raises(RuntimeError, match=r"not -0\.5"):
        start(polling_monitor, poll_s=-0.5)
