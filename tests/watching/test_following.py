"""Which topics follow the clock, computed from stretches and times alone."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from workbook.recording.recording import Stretch
from workbook.watching.following import follows

STEP_S = 0.05
FAST, SLOW = Stretch(40.0, 0.0, 9.0), Stretch(20.0, 9.0, 18.0)


def each(period: float, start: float, end: float) -> list[float]:
    """Return the times of a timer."""
    return [start + number * period for number in range(1, 1 + int((end - start) / period + 1e-9))]


def of_the_wall_clock(period: float, stretches: list[Stretch]) -> list[float]:
    """Return the times (s, simulated) of messages that are published every `period` real seconds."""
    times, real = [], 0.0
    for stretch in stretches:
        begun, real = real, real + (stretch.end - stretch.start) / stretch.speed
        moment = (begun // period + 1) * period
        while moment <= real:
            times.append(stretch.start + (moment - begun) * stretch.speed)
            moment += period
    return times


def test_equal_intervals_at_both_paces_follow() -> None:
    assert follows([FAST, SLOW], each(2.0, 0.0, 18.0), STEP_S) is True
    assert follows([FAST, SLOW], each(0.5, 0.0, 18.0), STEP_S) is True


def test_what_is_quicker_than_the_steps_of_a_slow_clock_proves_nothing() -> None:
    """On a busy machine, simulated time ran at speeds of 0.1 and 0.6. Most messages at 50 Hz fell into one step."""
    stretches = [Stretch(0.113, 0.0, 0.2), Stretch(0.605, 0.2, 4.7), Stretch(0.2, 4.7, 9.0)]
    times = [moment // STEP_S * STEP_S for moment in of_the_wall_clock(0.02, stretches)]
    assert follows(stretches, times, STEP_S) is not True


def test_a_wrong_rate_follows_as_well() -> None:
    assert follows([FAST, SLOW], each(1.3, 0.0, 18.0), STEP_S) is True


def test_what_stops_early_has_proved_it_before() -> None:
    stretches = [FAST, SLOW, Stretch(40.0, 18.0, 27.0), Stretch(20.0, 27.0, 36.0)]
    assert follows(stretches, each(2.0, 0.0, 20.0), STEP_S) is True


@pytest.mark.parametrize("times", [[], [2.0], each(2.0, 0.0, 9.0), each(4.0, 0.0, 18.0)])
def test_silence_and_too_few_messages_prove_nothing(times: list[float]) -> None:
    assert follows([FAST, SLOW], times, STEP_S) is None


def test_one_pace_proves_nothing() -> None:
    assert follows([FAST, Stretch(30.0, 9.0, 18.0)], each(1.0, 0.0, 18.0), STEP_S) is None
    assert follows([FAST], each(1.0, 0.0, 9.0), STEP_S) is None


@given(period=st.floats(0.005, 0.1), ratio=st.floats(2.0, 6.0), blocks=st.integers(1, 4))
def test_what_lives_on_the_wall_clock_is_never_taken_for_one_that_follows(
    period: float, ratio: float, blocks: int
) -> None:
    stretches = [
        Stretch(40.0 if number % 2 == 0 else 40.0 / ratio, 9.0 * number, 9.0 * (number + 1))
        for number in range(2 * blocks)
    ]
    assert follows(stretches, of_the_wall_clock(period, stretches), STEP_S) is not True


@given(period=st.floats(0.005, 0.1), slow=st.floats(0.1, 20.0), ratio=st.floats(2.0, 6.0))
def test_nor_is_it_where_messages_are_timed_by_the_steps_of_the_clock(
    period: float, slow: float, ratio: float
) -> None:
    stretches = [Stretch(slow * ratio, 0.0, 9.0), Stretch(slow, 9.0, 18.0)]
    times = [moment // STEP_S * STEP_S for moment in of_the_wall_clock(period, stretches)]
    assert follows(stretches, times, STEP_S) is not True


@given(
    period=st.floats(0.1, 2.0),
    speeds=st.lists(st.floats(1.0, 300.0), min_size=2, max_size=6),
)
def test_what_follows_is_never_taken_for_one_that_does_not(period: float, speeds: list[float]) -> None:
    stretches = [Stretch(speed, 9.0 * number, 9.0 * (number + 1)) for number, speed in enumerate(speeds)]
    assert follows(stretches, each(period, 0.0, 9.0 * len(speeds)), STEP_S) is not False


def test_phases_are_compared_in_which_the_messages_came() -> None:
    speeds = (7.8, 3.2, 6.8, 3.0, 7.4, 2.8, 4.0, 1.8)  # as measured on a busy machine
    stretches = [Stretch(speed, 2.5 * n, 2.5 * (n + 1)) for n, speed in enumerate(speeds)]
    assert follows(stretches, [0.5 * n for n in range(1, 13)], STEP_S) is True  # publishing stops after 6 s


def test_a_pace_that_changes_once_follows_as_well() -> None:
    """Five messages a second for 36 s, and then only every second one, as measured with a real program."""
    ends = (10.0, 17.6, 20.0, 30.0, 37.6, 40.0, 50.0, 57.6, 60.0)
    speeds = (90.0, 40.0, 95.0) * 3
    starts = (0.0, *ends)
    stretches = [Stretch(*one) for one in zip(speeds, starts, ends, strict=False)]
    times = [*each(0.2, 0.0, 36.0), *(36.0 + one for one in each(0.4, 0.0, 24.0))]
    assert follows(stretches, times, STEP_S) is True


@pytest.mark.parametrize("ratio", [2.0, 3.0])
@pytest.mark.parametrize("change", [9.0, 13.0, 27.0, 40.0, 63.0])
def test_nor_does_a_change_make_the_wall_clock_look_like_simulated_time(change: float, ratio: float) -> None:
    """Published every 0.02 real seconds, and later half as often."""
    stretches = [Stretch(40.0 if n % 2 == 0 else 40.0 / ratio, 9.0 * n, 9.0 * (n + 1)) for n in range(8)]
    first, then = (of_the_wall_clock(period, stretches) for period in (0.02, 0.04))
    times = [*(one for one in first if one <= change), *(one for one in then if one > change)]
    assert follows(stretches, times, STEP_S) is not True
