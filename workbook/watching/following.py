"""Determine whether a topic follows the simulated clock, by comparing its messages at two speeds of the clock.

If a program follows `/clock`, its intervals between messages, in simulated time, are equal at every speed. If a program
runs on the wall clock, these intervals grow with the speed. A *stretch* is a part of the watch with a constant clock
speed.
"""

import math
from collections.abc import Sequence
from itertools import pairwise
from statistics import fmean, median

from workbook.recording.recording import Recording, Stretch

LEAST_INTERVALS = 3
"""The least intervals required at each of the two speeds, because fewer may agree by chance."""
LEAST_RATIO = 2.0
"""The smallest ratio of the two speeds. If a program runs on the wall clock, its intervals differ by this ratio."""
MOST_OFF = 1.5
"""The largest acceptable factor between a topic's rates in simulated and in real time."""
LEAST_REAL_PERIODS = 2.5
LONGEST_STALL_S = 2.0
"""The longest delay of messages (s) that we attribute to a busy machine."""
ALIKE = 0.1
"""The largest relative difference between two typical intervals that count as equal."""


def follows(stretches: Sequence[Stretch], times: Sequence[float], step_s: float) -> bool | None:
    """Return whether messages that arrived at `times` (simulated time, s) have the same intervals at two speeds.

    The result is None if the messages prove neither. Silence, too few messages, and nearly equal speeds don't prove
    anything. Nor does a median interval of about one clock step (`step_s`, s), because an interval twice as long may be
    rounded to one step.
    """
    slow, fast = max(
        _ways_to_choose(stretches),
        key=lambda way: min(len(_intervals(times, side)) for side in way),  # the most intervals to compare
        default=([], []),
    )
    at_slow, at_fast = _intervals(times, slow), _intervals(times, fast)
    if min(len(at_slow), len(at_fast)) < LEAST_INTERVALS:
        return None
    if math.isclose(fmean(at_slow), fmean(at_fast), rel_tol=ALIKE) and fmean(at_slow) > 0.0:
        return True
    slower, faster = median(at_slow), median(at_fast)
    alike, different = _changes_of_pace(stretches, times, step_s)
    if not math.isclose(slower, faster, rel_tol=ALIKE):
        return alike > 0 and alike >= different
    if different > alike:
        return False
    return True if slower > 1.5 * step_s else None


def rates_differ(usual_s: float, real: Recording, topic: str) -> bool:
    """Return whether a topic's rate in real time differs from one message per `usual_s` (s).

    The rate differs if the topic's median or mean interval is off by more than a factor of `MOST_OFF`. It also differs
    if the topic was silent for more than both `LEAST_REAL_PERIODS` periods and `LONGEST_STALL_S`, because the topic may
    have stopped. If the recording is shorter than `LEAST_REAL_PERIODS` periods, return False.
    """
    few_s = LEAST_REAL_PERIODS * usual_s
    if usual_s <= 0.0 or real.watched_s < few_s:
        return False
    intervals = intervals_of(real, topic)
    if not intervals:
        return True
    moments = (0.0, *(arrival.t for arrival in real.topic(topic).arrivals), real.watched_s)
    if max(after - before for before, after in pairwise(moments)) > max(few_s, LONGEST_STALL_S):
        return True
    means = median(intervals), fmean(intervals)
    return not all(1 / MOST_OFF <= mean / usual_s <= MOST_OFF for mean in means)


def intervals_of(recording: Recording, topic: str) -> list[float]:
    """Return the intervals between a topic's messages, in seconds of simulated time."""
    return [after.t - before.t for before, after in pairwise(recording.topic(topic).arrivals)]


def _changes_of_pace(stretches: Sequence[Stretch], times: Sequence[float], step_s: float) -> tuple[int, int]:
    """Count the changes in clock speed that leave the median interval unchanged, and the other changes.

    If a program follows the clock but starts to publish more or less often, its intervals change once, regardless of
    the speed. If a program runs on the wall clock, its intervals change every time the speed does.
    """
    alike = different = 0
    for before, after in pairwise(stretches):
        if max(before.speed, after.speed) < LEAST_RATIO * min(before.speed, after.speed):
            continue
        both = _intervals(times, [before]), _intervals(times, [after])
        if min(map(len, both)) < LEAST_INTERVALS:
            continue
        one, other = map(median, both)
        same = one > 1.5 * step_s and math.isclose(one, other, rel_tol=ALIKE)
        alike, different = alike + same, different + (not same)
    return alike, different


def _ways_to_choose(stretches: Sequence[Stretch]) -> list[tuple[list[Stretch], list[Stretch]]]:
    """Return all ways to divide stretches into slow and fast ones, as pairs (slow, fast).

    Fast stretches are at least twice as fast as the fastest slow stretch. Stretches whose speed lies between the two
    belong to neither group.
    """
    ordered = sorted(stretches, key=lambda stretch: stretch.speed)
    ways = []
    for number in range(1, len(ordered)):
        slow = ordered[:number]
        ways.append((slow, [stretch for stretch in ordered if stretch.speed >= LEAST_RATIO * slow[-1].speed]))
    return ways


def _intervals(times: Sequence[float], stretches: Sequence[Stretch]) -> list[float]:
    """Return the intervals (s) between consecutive messages within each of these stretches."""
    return [
        after - before
        for stretch in stretches
        for before, after in pairwise(t for t in times if stretch.start < t <= stretch.end)
    ]
