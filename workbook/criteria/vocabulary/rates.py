"""Judge a topic's timing: its rate, message count, and period.

A topic's *pace* is the distribution of its messages over time (see `Pace`).
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property, wraps
from itertools import pairwise
from statistics import median

from workbook.criteria.criterion import Topic
from workbook.criteria.rules import Cause, Words, otherwise
from workbook.criteria.verdict import Verdict, passed
from workbook.criteria.vocabulary.estimators import Pace, pace
from workbook.criteria.vocabulary.floods import flood
from workbook.criteria.vocabulary.phrasing import count, hertz, number, seconds
from workbook.criteria.vocabulary.silences import gone_silent, others_within, program_ended
from workbook.criteria.vocabulary.spins import disturbs_itself
from workbook.criteria.vocabulary.topics import if_all_kept, if_messages, window_of
from workbook.recording.recording import Recording

WORDS = Words(__file__)

RATE_TOLERANCE = 0.2
LONGEST_GAP_PERIODS = 1.5
INTERVAL_TOLERANCE = 0.1
MEAN_TOLERANCE = 0.04
LEAST_INTERVALS = 3
UNEVEN = 0.3
FIRST_LATE_PERIODS = 1.2


@dataclass(frozen=True)
class _Rhythm:
    """The rhythm of a topic's messages, compared with the required rate.

    `counted`: whether to compute the rate as the number of messages divided by the time watched, not from the
    intervals.
    """

    recording: Recording
    topic: Topic
    counted: bool = False

    @cached_property
    def seen(self) -> Pace:
        return topic_pace(self.recording, self.topic)

    @cached_property
    def watched_s(self) -> float:
        start, end = _watched(self.recording, self.topic)
        return end - start

    @property
    def last(self) -> float:
        """The time of the last message (s)."""
        return self.recording.topic(self.topic.name).arrivals[-1].t

    @property
    def wanted_hz(self) -> float:
        return self.topic.hz or 0.0

    @property
    def low(self) -> float:
        return self.wanted_hz * (1 - RATE_TOLERANCE)

    @property
    def high(self) -> float:
        return self.wanted_hz * (1 + RATE_TOLERANCE)

    @property
    def longest_gap_s(self) -> float:
        return LONGEST_GAP_PERIODS * self.topic.period

    @property
    def hz(self) -> float:
        return self.seen.count / self.watched_s if self.counted else self.seen.hz or 0.0

    @property
    def in_fast_bursts(self) -> bool:
        return self.seen.in_bursts and self.hz > self.high

    @property
    def stops(self) -> bool:
        longest = LONGEST_GAP_PERIODS * max(self.topic.period, self.seen.typical_interval or 0.0)
        return self.seen.gap.kind == "after" and self.seen.gap.seconds > longest

    @property
    def has_gap(self) -> bool:
        return self.seen.gap.seconds > self.longest_gap_s + (self.recording.step_s or 0.0)

    @property
    def first_is_late(self) -> bool:
        gap = self.seen.gap
        return gap.kind == "before" and gap.seconds > FIRST_LATE_PERIODS * self.topic.period

    @cached_property
    def intervals(self) -> list[float]:
        arrivals = self.recording.topic(self.topic.name).arrivals
        return [after.t - before.t for before, after in pairwise(arrivals)]

    @property
    def shortest(self) -> float:
        return min(self.intervals)

    @property
    def longest(self) -> float:
        return max(self.intervals)

    @property
    def soon(self) -> int:
        """The number of messages that arrive much too soon after the previous one."""
        return sum(one < (1 - UNEVEN) * self.topic.period for one in self.intervals)

    @property
    def late(self) -> int:
        return sum(one > (1 + UNEVEN) * self.topic.period for one in self.intervals)

    @cached_property
    def going_on(self) -> list[str]:
        """The other topics that have messages during the longest gap."""
        gap = self.seen.gap
        return [] if self.seen.in_bursts else others_within(self.recording, self.topic, gap.start, gap.end)

    @cached_property
    def change(self) -> tuple[str, float, str] | None:
        """A change from one even pace to another: the interval before it, its time (s), and the interval after it.

        The intervals are strings. None if there was no such change.
        """
        intervals = self.intervals
        at_first = median(intervals[:LEAST_INTERVALS]) if intervals else 0.0
        same = [abs(one - at_first) <= UNEVEN * at_first for one in intervals]
        change = same.index(False) if False in same else len(same)
        before, after = intervals[:change], intervals[change + 1 :]
        if min(len(before), len(after)) < LEAST_INTERVALS or any(same[change:]):
            return None
        later = median(after)
        if not (_all_about(before, at_first) and _all_about(after, later)):
            return None
        moment = self.recording.topic(self.topic.name).arrivals[change].t
        return hertz(at_first), moment, hertz(later)

    @property
    def can_tell(self) -> bool:
        """Whether the steps of simulated time are short enough to measure this rate. A timer fires once per step."""
        return self.recording.step_s is None or self.hz * self.recording.step_s <= 0.5 + 1e-6

    @property
    def swapped(self) -> bool:
        """Whether the measured rate is about the reciprocal of the required rate."""
        wanted = self.wanted_hz
        return self.can_tell and wanted != 1.0 and math.isclose(self.hz, 1 / wanted, rel_tol=0.15)

    @property
    def even(self) -> bool:
        intervals = self.intervals
        return self.recording.in_lockstep and bool(intervals) and _all_about(intervals, median(intervals))

    # phrases for the catalog
    @property
    def once(self) -> str:
        n = self.seen.count
        return "a single message" if n == 1 else f"{n} messages at one moment, and no others"

    @property
    def groups(self) -> str:
        return "pairs" if self.seen.burst == 2 else f"groups of {self.seen.burst}"

    @property
    def where(self) -> str:
        gap = self.seen.gap
        return "before the first message" if gap.kind == "before" else f"starting at {seconds(gap.start)}"

    @property
    def hz_text(self) -> str:
        return hertz(self.hz)

    @property
    def rounded_hz(self) -> str:
        fastest = number(0.5 / (self.recording.step_s or 1.0))
        return f"{self.hz_text} Hz" if self.can_tell else f"faster than {fastest} Hz"

    @property
    def other_hz(self) -> str:
        """The measured rate, with enough digits to show that it's outside the tolerance."""
        rounded = [float(f"{self.hz:.{digits}g}") for digits in (2, 3, 4)]
        told = next((one for one in rounded if not self.low <= one <= self.high), self.hz)
        if not self.can_tell:
            return self.rounded_hz
        every = f"one message every {hertz(1 / self.hz)} s"
        return f"{told:g} Hz, {every} ({count(self.seen.count, 'message')})"

    @property
    def how_fast(self) -> str:
        factor = hertz(self.hz / self.wanted_hz)
        return f"about {factor} times the expected rate" if self.can_tell else "far above the expected rate"

    @property
    def usual_interval(self) -> str:
        """The interval to report: the typical interval, or the mean interval if only the mean is wrong."""
        typical, hz = self.seen.typical_interval or 0.0, self.seen.hz
        is_typical = abs(typical - self.topic.period) <= INTERVAL_TOLERANCE * self.topic.period
        return f"on average {1 / hz:.3g} s" if is_typical and hz else f"typically {typical:.3g} s"

    @property
    def wanted(self) -> int:
        """The number of messages that are due in the time watched."""
        return round(self.watched_s * self.wanted_hz)


_ONLY = WORDS.seen("rate.only", _Rhythm)
_IN_BURSTS = WORDS.cause("rate.in-bursts", _Rhythm, about_time=True)
_ONCE = WORDS.cause("rate.once", _Rhythm, about_time=True)
_STOPS = WORDS.cause("rate.stops", _Rhythm, about_time=True)
_CHANGES = WORDS.rules(_Rhythm, "rate", ("changes", lambda one: one.change), about_time=True)
_OTHER_RATE = WORDS.rules(
    _Rhythm,
    "rate",
    ("period-for-frequency", lambda one: one.swapped),
    ("too-fast", lambda one: one.hz > one.wanted_hz),
    ("evenly-too-slow", lambda one: one.even),
    ("too-slow", otherwise),
    about_time=True,
)
_GAP = WORDS.rules(
    _Rhythm,
    "rate",
    ("begins-late", lambda one: one.going_on and one.seen.gap.kind == "before"),
    ("uneven", lambda one: one.going_on and min(one.soon, one.late) >= UNEVEN * len(one.intervals)),
    ("skips", lambda one: one.going_on),
    ("groups-with-silences", lambda one: one.seen.in_bursts),
    ("silence", otherwise),
    about_time=True,
)
_FEW = WORDS.rules(
    _Rhythm, "rate", ("first-late", lambda one: one.first_is_late), ("too-few", otherwise), about_time=True
)
_COUNTED = WORDS.seen("counts.other", _Rhythm)
_SINGLE = WORDS.cause("keeps-period.once", _Rhythm, about_time=True)
_OTHER_PERIOD = WORDS.cause("keeps-period.other-period", _Rhythm, about_time=True)


def _of_pace(judge: Callable[[Recording, Topic], Verdict]) -> Callable[[Recording, Topic], Verdict]:
    """Decorate a function that judges a topic's pace: set `pace_of` to the topic in every failed verdict.

    If the topic follows simulated time, such a verdict from simulated time is final. If the program's source spins in a
    callback or has a similar fault (see `disturbs_itself`), the verdict blames that fault.
    """

    @wraps(judge)
    def named(recording: Recording, topic: Topic) -> Verdict:
        verdict = judge(recording, topic)
        if verdict.ok:
            return verdict
        named_already = not verdict.about_time or verdict.cause.startswith("spin.")
        held = None if named_already else disturbs_itself(recording, verdict.saw, verdict.expected)
        return replace(held or verdict, pace_of=topic.name)

    return named


def topic_pace(recording: Recording, topic: Topic) -> Pace:
    """Return the pace of `topic`: its message count, rate, typical interval, and longest gap, in simulated time."""
    seen = recording.topic(topic.name)
    start, end = _watched(recording, topic)
    return pace([arrival.t for arrival in seen.arrivals], start, end, topic.period)


@_of_pace
@if_all_kept
def rate(recording: Recording, topic: Topic) -> Verdict:
    """Check that a topic's mean rate is off by at most 20 %, and no silence is longer than one and a half periods."""
    rhythm = _Rhythm(recording, topic)
    only, expected = _ONLY(rhythm)
    flooded = flood(recording, topic, expected)
    if flooded is not None:
        return flooded
    if rhythm.seen.hz is None:
        return _breaks_off(rhythm, _ONCE)
    if rhythm.in_fast_bursts:
        return _IN_BURSTS.verdict(rhythm)
    if rhythm.stops:
        return _breaks_off(rhythm, _STOPS)
    if not rhythm.low <= rhythm.hz <= rhythm.high:
        return _CHANGES.first(rhythm) or _OTHER_RATE.verdict(rhythm)
    if rhythm.has_gap:
        return _CHANGES.first(rhythm) or _GAP.verdict(rhythm)
    if rhythm.seen.count <= LEAST_INTERVALS:
        return program_ended(recording, only, expected) or _FEW.verdict(rhythm)
    return passed(f"{hertz(rhythm.hz)} Hz over {count(rhythm.seen.count, 'message')}")


def _watched(recording: Recording, topic: Topic) -> tuple[float, float]:
    """Return the start and end (s) of a topic's watch. If the program exited by itself, the end is its last message.

    Simulated time may run on for some seconds before the judge notices such an exit. Other functions judge the exit
    itself. If more messages arrived than are kept, the watch ends with the first message that wasn't kept.
    """
    start, end = window_of(recording, recording.topic(topic.name))
    if recording.process.ended_by == "itself":
        last = max(
            (one.t for name in recording.wanted for one in recording.topic(name).arrivals), default=end
        )
        end = min(end, last)
    full_at = recording.topic(topic.name).full_at
    return start, max(start, end if full_at is None else min(end, full_at))


def _all_about(intervals: list[float], typical: float) -> bool:
    return all(abs(one - typical) <= INTERVAL_TOLERANCE * typical for one in intervals)


def _breaks_off(rhythm: _Rhythm, cause: Cause) -> Verdict:
    verdict = cause.verdict(rhythm)
    silent = gone_silent(rhythm.recording, rhythm.topic, rhythm.last, verdict.saw, verdict.expected)
    return silent or verdict


@_of_pace
@if_all_kept
def counts(recording: Recording, topic: Topic) -> Verdict:
    """Check that the topic's window contains one message per period, give or take one message at the window's edge."""
    rhythm = _Rhythm(recording, topic, counted=True)
    came = rhythm.seen.count
    if abs(came - rhythm.wanted) <= 1:
        return passed(f"{came} messages in {seconds(rhythm.watched_s)}")
    if rhythm.watched_s <= 0.0:
        return _breaks_off(rhythm, _ONCE)
    saw, expected = _COUNTED(rhythm)
    ended = program_ended(recording, saw, expected) if came < rhythm.wanted else None
    changes = _CHANGES.first(rhythm)
    if ended is None and changes is not None:
        return replace(changes, expected=expected)
    return ended or replace(_OTHER_RATE.verdict(rhythm), saw=saw, expected=expected)


@_of_pace
@if_messages
def keeps_period(recording: Recording, topic: Topic) -> Verdict:
    """Check that the typical interval differs from the topic's period by at most a tenth. A few messages are enough.

    On simulated time, which yields many messages, the mean interval must also be within 4 % of the period.
    """
    rhythm = _Rhythm(recording, topic)
    typical, hz = rhythm.seen.typical_interval, rhythm.seen.hz
    if typical is None:
        single = _SINGLE.verdict(rhythm)
        return program_ended(recording, single.saw, single.expected) or single
    mean = 1 / hz if recording.clock == "simulated" and hz else topic.period
    is_typical = abs(typical - topic.period) <= INTERVAL_TOLERANCE * topic.period
    if is_typical and abs(mean - topic.period) <= MEAN_TOLERANCE * topic.period:
        return passed(f"one message every {number(topic.period)} s")
    return _OTHER_PERIOD.verdict(rhythm)
