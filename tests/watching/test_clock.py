"""Robot time in steps: how far each goes, and what is remembered of it."""

import time

import pytest
from rosgraph_msgs.msg import Clock

from workbook.watching.clock import START_NS, SimulatedClock


class Bench:
    """Stands in for a node, and keeps what is published."""

    def __init__(self) -> None:
        self.published: list[int] = []

    def create_publisher(self, *_: object) -> "Bench":
        return self

    def publish(self, message: Clock) -> None:
        self.published.append(message.clock.sec * 1_000_000_000 + message.clock.nanosec - START_NS)


def test_steps_are_equal_and_several_can_be_taken_at_once() -> None:
    bench = Bench()
    clock = SimulatedClock(bench, 0.1)
    clock.run_at(10.0)
    clock.publish()
    clock.advance()
    clock.advance()
    clock.run_at(1.0, stride=5)
    clock.advance()
    clock.run_at(1.0)
    clock.advance()
    assert bench.published == [0, 100_000_000, 200_000_000, 700_000_000, 800_000_000]
    assert clock.now == pytest.approx(0.8)
    assert clock.robot_time(time.monotonic()) == pytest.approx(0.8)


def test_several_steps_at_once_are_due_when_so_much_time_has_passed() -> None:
    clock = SimulatedClock(Bench(), 0.1)
    clock.run_at(1.0)
    one = clock.until_due()
    clock.run_at(1.0, stride=50)
    assert one <= 0.1
    assert 0.1 < clock.until_due() <= 5.0
