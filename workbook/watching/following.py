"""Whether a topic follows the simulated clock, as its messages at two paces show.

A program that follows `/clock` publishes at the same intervals of simulated time, however fast the clock is driven. One
that lives on the wall clock does not: its intervals of simulated time grow with the speed.
"""

import math
from collections.abc import Sequence
from itertools import pairwise
from statistics import fmean, median

from workbook.recording.recording import Phase, Recording

LEAST_INTERVALS = 3
"""At each of the two paces: fewer can agree by chance."""
LEAST_RATIO = 2.0
"""Between the two paces. What lives on the wall clock shows intervals that differ by that much."""
MOST_OFF = 1.5
"""Factor between the rates of a topic in simulated and in real time: more is a finding."""
LEAST_REAL_PERIODS = 2.5
LONGEST_STALL_S = 2.0
"""A busy machine may keep messages back for so long (s)."""
ALIKE = 0.1
"""How much typical intervals may differ, as a share."""


def follows(phases: Sequence[Phase], times: Sequence[float], step_s: float) -> bool | None:
    """Whether messages that came at `times` (s of simulated time) keep their intervals at two paces; None: not proved.

    Nothing is proved by silence, by too few messages, and by paces that came out too much alike. Nor does it prove
    that a topic follows if the median interval is a single step of the clock (`step_s`, s), or none: one that is twice
    as long may be rounded to the same.
    """
    slow, fast = max(
        _ways_to_choose(phases),
        key=lambda way: min(len(_intervals(times, side)) for side in way),  # where most is to be compared
        default=([], []),
    )
    at_slow, at_fast = _intervals(times, slow), _intervals(times, fast)
    if min(len(at_slow), len(at_fast)) < LEAST_INTERVALS:
        return None
    if math.isclose(fmean(at_slow), fmean(at_fast), rel_tol=ALIKE) and fmean(at_slow) > 0.0:
        return True
    slower, faster = median(at_slow), median(at_fast)
    alike, different = _changes_of_pace(phases, times, step_s)
    if not math.isclose(slower, faster, rel_tol=ALIKE):
        return alike > 0 and alike >= different
    if different > alike:
        return False
    return True if slower > 1.5 * step_s else None


def rates_differ(usual_s: float, real: Recording, topic: str) -> bool:
    """Whether a topic came at another rate in real time than once in `usual_s` (s).

    Its typical or its mean interval differs by more than `MOST_OFF`, or it was silent for `LEAST_REAL_PERIODS`, as a
    topic is that has stopped. Where the real seconds do not hold so many periods, they show nothing.
    """
    few_s = LEAST_REAL_PERIODS * usual_s
    if usual_s <= 0.0 or real.simulated_s < few_s:
        return False
    intervals = intervals_of(real, topic)
    if not intervals:
        return True
    moments = (0.0, *(arrival.t for arrival in real.topic(topic).arrivals), real.simulated_s)
    if max(after - before for before, after in pairwise(moments)) > max(few_s, LONGEST_STALL_S):
        return True
    means = median(intervals), fmean(intervals)
    return not all(1 / MOST_OFF <= mean / usual_s <= MOST_OFF for mean in means)


def intervals_of(recording: Recording, topic: str) -> list[float]:
    """From each message of a topic to the next one (s of simulated time)."""
    return [after.t - before.t for before, after in pairwise(recording.topic(topic).arrivals)]


def _changes_of_pace(phases: Sequence[Phase], times: Sequence[float], step_s: float) -> tuple[int, int]:
    """At how many changes of the clock's pace the typical interval stays the same, and at how many it does not.

    A program that follows, and comes to publish more often or more rarely, changes its intervals once, at a moment of
    its own. Those of a program that lives on the wall clock change with every pace.
    """
    alike = different = 0
    for before, after in pairwise(phases):
        if max(before.speed, after.speed) < LEAST_RATIO * min(before.speed, after.speed):
            continue
        both = _intervals(times, [before]), _intervals(times, [after])
        if min(map(len, both)) < LEAST_INTERVALS:
            continue
        one, other = map(median, both)
        same = one > 1.5 * step_s and math.isclose(one, other, rel_tol=ALIKE)
        alike, different = alike + same, different + (not same)
    return alike, different


def two_paces(phases: Sequence[Phase]) -> tuple[list[Phase], list[Phase]]:
    """The phases that count as slow and as fast: each fast one at least twice as fast as every slow one.

    Of all ways to choose them, the one with the most simulated time on its shorter side; two empty lists if there is
    none.
    """
    ways = _ways_to_choose(phases)
    best = max(ways, key=lambda way: min(map(_robot_s, way)), default=([], []))
    return best if min(map(_robot_s, best)) > 0.0 else ([], [])


def _ways_to_choose(phases: Sequence[Phase]) -> list[tuple[list[Phase], list[Phase]]]:
    """All ways to take some phases as slow and all that are at least twice as fast as the fastest of them as fast."""
    ordered = sorted(phases, key=lambda phase: phase.speed)
    ways = []
    for number in range(1, len(ordered)):
        slow = ordered[:number]
        ways.append((slow, [phase for phase in ordered if phase.speed >= LEAST_RATIO * slow[-1].speed]))
    return ways


def _robot_s(phases: Sequence[Phase]) -> float:
    return sum(phase.end - phase.start for phase in phases)


def _intervals(times: Sequence[float], phases: Sequence[Phase]) -> list[float]:
    """From one message to the next, where both lie in the same of these phases (s)."""
    return [
        after - before
        for phase in phases
        for before, after in pairwise(t for t in times if phase.start < t <= phase.end)
    ]
