"""How many answers run at once on the wall clock: as many as keep the processors at work, each answer once."""

import threading
from collections.abc import Iterator, Sequence

import pytest

from tests.exercises.pacing import Pace, in_parts, paced


def test_a_lane_comes_while_processors_idle_and_goes_while_they_are_busy() -> None:
    pace = Pace(fewest=2, most=4)
    seen = [pace.lanes]
    for idle in (0.9, 0.9, 0.9, 0.2, 0.0, 0.0, 0.0, 0.2, 0.9):
        pace.follow(idle)
        seen.append(pace.lanes)
    assert seen == [2, 3, 4, 4, 4, 3, 2, 2, 2, 3]


@pytest.mark.parametrize(("idle", "most_at_once"), [(0.0, 2), (0.9, 5)])
def test_lanes_at_work_follow_the_processors(idle: float, most_at_once: int) -> None:
    """Each part waits until as many lanes as are allowed are at work, or until no further one can come."""
    at_work, most = 0, 0
    changed = threading.Condition()

    def judge(part: Sequence[int]) -> Iterator[int]:
        nonlocal at_work, most
        with changed:
            at_work += 1
            most = max(most, at_work)
            changed.notify_all()
            assert changed.wait_for(lambda: most >= most_at_once, 60.0)
            at_work -= 1
        yield from part

    numbers = [*range(20)]
    judged = [*paced(in_parts(numbers, 2), judge, Pace(fewest=2, most=5), lambda: idle, look_s=0.0)]
    assert sorted(judged) == numbers
    assert most == most_at_once


def test_what_a_lane_raises_is_not_lost() -> None:
    def judge(part: Sequence[int]) -> Iterator[int]:
        raise ValueError(part)
        yield 0

    with pytest.raises(ValueError, match="1"):
        list(paced([[1]], judge, Pace(), lambda: 0.0))
