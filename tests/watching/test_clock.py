"""Simulated time in steps: where it begins, how far each step goes, and its record."""

import time

import pytest
from rosgraph_msgs.msg import Clock

from workbook.watching.clock import SimulatedClock


class StandIn:
    """Replaces a node, and stores the published times (ns)."""

    def __init__(self) -> None:
        self.published: list[int] = []

    def create_publisher(self, *_: object) -> "StandIn":
        return self

    def publish(self, message: Clock) -> None:
        self.published.append(message.clock.sec * 1_000_000_000 + message.clock.nanosec)


def test_simulated_time_begins_at_the_present_time_of_day_and_goes_on_in_equal_steps() -> None:
    node = StandIn()
    before = time.time_ns()
    clock = SimulatedClock(node, 0.1)
    after = time.time_ns()
    clock.publish()
    clock.advance()
    clock.advance()
    first, *later = node.published
    assert before <= first <= after
    assert later == [first + 100_000_000, first + 200_000_000]
    assert clock.now == pytest.approx(0.2)
    assert clock.simulated_time(time.monotonic()) == pytest.approx(0.2)


def test_a_step_is_due_after_the_time_that_the_speed_gives_it() -> None:
    clock = SimulatedClock(StandIn(), 0.1)
    clock.run_at(0.01)
    assert 5.0 < clock.until_due() <= 10.0
    clock.run_at(1e9)
    assert clock.until_due() < 0.001
