"""Estimates of rates, gaps, and bursts when a busy machine distorts the arrival times."""

import math
from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.criteria.by_hand import every, on_topic, recorded
from workbook.criteria import Topic, rate
from workbook.criteria.vocabulary.estimators import burst_size, group_starts, longest_gap, mean_rate, pace

TOLERANCE = 0.2
periods = st.floats(0.02, 5.0)
sorted_times = st.lists(st.floats(-1e6, 1e6), max_size=60).map(sorted)


@st.composite
def jittered(draw: st.DrawFn, least: int = 6, jitter: float = 0.1) -> tuple[list[float], float]:
    """Return the arrivals of an even stream. Each is early or late by up to `jitter` periods."""
    period = draw(periods)
    shifts = draw(st.lists(st.floats(-jitter, jitter), min_size=least, max_size=40))
    return [period * (index + 1 + shift) for index, shift in enumerate(shifts)], period


@given(jittered())
def test_mean_rate_stays_within_tolerance_under_jitter(stream: tuple[list[float], float]) -> None:
    times, period = stream
    assert mean_rate(times) == pytest.approx(1 / period, rel=TOLERANCE)


@given(jittered(least=8), st.data())
def test_one_lost_message_leaves_the_rate_within_tolerance(
    stream: tuple[list[float], float], data: st.DataObject
) -> None:
    times, period = stream
    lost = data.draw(st.integers(0, len(times) - 1))
    rest = times[:lost] + times[lost + 1 :]
    assert mean_rate(rest) == pytest.approx(1 / period, rel=TOLERANCE)
    assert burst_size(rest, period) == 1


@given(jittered(), st.floats(1.6, 20.0))
def test_another_rate_never_passes_for_the_expected_one(
    stream: tuple[list[float], float], factor: float
) -> None:
    """Jitter can't bring a rate that is off by 60% or more back into the tolerance."""
    times, period = stream
    hz = mean_rate(times)
    assert hz is not None
    for expected in (1 / period * factor, 1 / period / factor):
        assert not expected * (1 - TOLERANCE) <= hz <= expected * (1 + TOLERANCE)


@given(jittered(), st.integers(2, 5), st.floats(0.0, 0.02))
def test_groups_are_recognized(stream: tuple[list[float], float], size: int, inside: float) -> None:
    starts, period = stream
    times = sorted(start + member * inside * period for start in starts for member in range(size))
    assert burst_size(times, period) == size
    assert pace(times, 0.0, times[-1], period).in_bursts


@given(jittered())
def test_an_even_stream_is_no_group(stream: tuple[list[float], float]) -> None:
    times, period = stream
    assert burst_size(times, period) == 1


@given(st.integers(4, 400), periods, st.floats(6.0, 100.0))
def test_a_much_faster_stream_is_even_and_no_group(count: int, period: float, factor: float) -> None:
    assert burst_size(every(period / factor, count), period) == 1


@given(sorted_times, st.floats(0.0, 50.0), st.floats(0.0, 50.0))
def test_longest_gap_covers_the_edges(times: list[float], before: float, after: float) -> None:
    start = (times[0] if times else 0.0) - before
    end = (times[-1] if times else 0.0) + after
    gap = longest_gap(times, start, end)
    corners = [start, *times, end]
    assert gap.seconds == max(b - a for a, b in pairwise(corners))
    assert gap.start in corners
    assert gap.end in corners
    assert {"before": gap.start == start, "after": gap.end == end}.get(gap.kind, True)


@pytest.mark.parametrize(
    ("times", "kind", "span"),
    [
        ([5.0, 6.0, 7.0], "before", (0.0, 5.0)),
        ([1.0, 2.0, 6.0, 7.0], "between", (2.0, 6.0)),
        ([1.0, 2.0], "after", (2.0, 8.0)),
        ([], "nothing", (0.0, 8.0)),
    ],
)
def test_longest_gap_tells_where(times: list[float], kind: str, span: tuple[float, float]) -> None:
    gap = longest_gap(times, 0.0, 8.0)
    assert (gap.kind, gap.start, gap.end) == (kind, *span)


@given(sorted_times, st.floats(0.0, 10.0), st.floats(0.0, 10.0))
def test_wider_groups_are_never_more_groups(times: list[float], near: float, more: float) -> None:
    assert len(group_starts(times, near + more)) <= len(group_starts(times, near))


@given(jittered(), st.integers(1, 30))
def test_a_message_inside_never_widens_the_longest_gap(stream: tuple[list[float], float], place: int) -> None:
    times, _ = stream
    start, end = times[0] - 1.0, times[-1] + 1.0
    extra = start + (end - start) * place / 31
    assert longest_gap(sorted([*times, extra]), start, end).seconds <= longest_gap(times, start, end).seconds


@given(jittered(), st.floats(1.01, 10.0))
def test_stretching_time_lowers_the_rate_alike(stream: tuple[list[float], float], factor: float) -> None:
    times, _ = stream
    hz, slower = mean_rate(times), mean_rate([time * factor for time in times])
    assert hz is not None
    assert slower == pytest.approx(hz / factor)


@given(sorted_times, periods)
def test_any_sorted_arrivals_are_described(times: list[float], period: float) -> None:
    seen = pace(times, min(times, default=0.0), max(times, default=0.0), period)
    assert seen.count == len(times)
    assert seen.burst >= 1
    assert seen.gap.seconds >= 0
    if seen.hz is not None:
        assert seen.hz > 0


@given(sorted_times, st.sampled_from([0.5, 1.0, 10.0]))
def test_the_verdict_on_any_arrivals_is_a_full_sentence(times: list[float], hz: float) -> None:
    times = [round(time, 6) for time in times]
    topic = Topic("/robot/battery", "std_msgs/msg/Float32", hz)
    window = (min(times, default=0.0), max(times, default=0.0) + 1.0)
    verdict = rate(recorded(on_topic(topic.name, topic.type, times, window=window)), topic)
    assert verdict.saw
    if not verdict.ok:
        assert verdict.expected
        assert verdict.because
        assert verdict.try_this
        assert not any(odd in verdict.saw for odd in ("inf", "nan")), verdict.saw


@given(jittered(least=8, jitter=0.1), st.data())
def test_rate_accepts_jitter_and_a_late_subscriber(
    stream: tuple[list[float], float], data: st.DataObject
) -> None:
    times, period = stream
    topic = Topic("/robot/battery", "std_msgs/msg/Float32", 1 / period)
    late = data.draw(st.integers(0, 3))
    window = (times[late] - period / 2, times[-1] + period / 2)
    verdict = rate(recorded(on_topic(topic.name, topic.type, times[late:], window=window)), topic)
    assert verdict.ok, verdict


def test_mean_rate_needs_two_different_moments() -> None:
    assert mean_rate([]) is None
    assert mean_rate([1.0]) is None
    assert mean_rate([1.0, 1.0]) is None
    assert math.isclose(mean_rate([1.0, 3.0]) or 0.0, 0.5)
