"""Judges time: rates, counts and periods of a topic."""

import math
from collections.abc import Callable
from dataclasses import replace
from functools import wraps
from itertools import pairwise
from statistics import median

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.estimators import Pace, pace
from workbook.criteria.vocabulary.floods import flood
from workbook.criteria.vocabulary.phrasing import count, hertz, listing, number, seconds
from workbook.criteria.vocabulary.silences import gone_silent, others_within, program_ended
from workbook.criteria.vocabulary.spins import disturbs_itself
from workbook.criteria.vocabulary.topics import if_all_kept, if_messages, window_of
from workbook.recording.recording import Recording

RATE_TOLERANCE = 0.2
LONGEST_GAP_PERIODS = 1.5
INTERVAL_TOLERANCE = 0.1
MEAN_TOLERANCE = 0.04
LEAST_INTERVALS = 3
UNEVEN = 0.3
FIRST_LATE_PERIODS = 1.2


def _of_pace(judge: Callable[[Recording, Topic], Verdict]) -> Callable[[Recording, Topic], Verdict]:
    """Name the topic whose pace was judged: if it follows simulated time, what simulated time has shown is final."""

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
    """How the messages of `topic` are spread over its window, in simulated time: count, rate, typical interval, gap."""
    seen = recording.topic(topic.name)
    start, end = _watched(recording, topic)
    return pace([arrival.t for arrival in seen.arrivals], start, end, topic.period)


@_of_pace
@if_all_kept
def rate(recording: Recording, topic: Topic) -> Verdict:
    """Messages come at the topic's rate: mean within 20 %, no silence longer than one and a half periods."""
    assert topic.hz is not None
    seen = topic_pace(recording, topic)
    flooded = flood(recording, topic, _rate_expected(topic))
    if flooded is not None:
        return flooded
    if seen.hz is None:
        return _at_one_moment(recording, topic, seen)
    low, high = _tolerated(topic)
    if seen.in_bursts and seen.hz > high:
        return _in_bursts(topic, seen, seen.hz)
    stopped_s = LONGEST_GAP_PERIODS * max(topic.period, seen.typical_interval or 0.0)
    if seen.gap.kind == "after" and seen.gap.seconds > stopped_s:
        return _stops(recording, topic, seen)
    if not low <= seen.hz <= high:
        saw, expected = _rate_seen(recording, topic, seen), _rate_expected(topic)
        return _changes(recording, topic, expected) or _other_rate(recording, topic, seen.hz, saw, expected)
    if seen.gap.seconds > LONGEST_GAP_PERIODS * topic.period + (recording.step_s or 0.0):
        return (
            _changes(recording, topic, _rate_expected(topic))
            or _skips(recording, topic, seen)
            or _falls_silent(topic, seen)
        )
    if seen.count <= LEAST_INTERVALS:
        return _too_few(recording, topic, seen)
    return passed(f"{hertz(seen.hz)} Hz over {count(seen.count, 'message')}")


def _watched(recording: Recording, topic: Topic) -> tuple[float, float]:
    """Begin and end (s) of the watch over a topic; of a program that ended by itself, until its very last message.

    Simulated time may run on for some seconds until such an end is noticed. That it ended is judged, but not here.
    Where more came than is kept, the watch ends with the first message that was not.
    """
    start, end = window_of(recording, recording.topic(topic.name))
    if recording.process.ended_by == "itself":
        last = max(
            (one.t for name in recording.wanted for one in recording.topic(name).arrivals), default=end
        )
        end = min(end, last)
    full_at = recording.topic(topic.name).full_at
    return start, max(start, end if full_at is None else min(end, full_at))


def _tolerated(topic: Topic) -> tuple[float, float]:
    hz = topic.hz or 0.0
    return hz * (1 - RATE_TOLERANCE), hz * (1 + RATE_TOLERANCE)


def _rate_expected(topic: Topic) -> str:
    low, high = _tolerated(topic)
    return (
        f"{number(topic.hz or 0.0)} Hz: one message every {number(topic.period)} s "
        f"({number(low)} to {number(high)} Hz, no gap over {number(LONGEST_GAP_PERIODS * topic.period)} s)"
    )


def _watched_s(recording: Recording, topic: Topic) -> str:
    start, end = _watched(recording, topic)
    return seconds(end - start)


def _at_one_moment(recording: Recording, topic: Topic, seen: Pace) -> Verdict:
    once = "a single message" if seen.count == 1 else f"{seen.count} messages at one moment, and no others"
    saw, expected = f"{once} in {_watched_s(recording, topic)}", _rate_expected(topic)
    last = recording.topic(topic.name).arrivals[-1].t
    return gone_silent(recording, topic, last, saw, expected) or failed(
        "rate.once",
        saw,
        expected,
        "The message is published once, or far too rarely.",
        f"Create a timer: publish in a callback, and let create_timer({topic.period}, ...) call it.",
        about_time=True,
    )


def _groups(seen: Pace) -> str:
    return "pairs" if seen.burst == 2 else f"groups of {seen.burst}"


def _in_bursts(topic: Topic, seen: Pace, hz: float) -> Verdict:
    return failed(
        "rate.in-bursts",
        f"{hertz(hz)} Hz: messages arrive in {_groups(seen)}",
        _rate_expected(topic),
        "Two timers call the same function, two publishers share the topic, or one callback publishes twice.",
        "Keep one timer and one publish() for this topic.",
        about_time=True,
    )


def _stops(recording: Recording, topic: Topic, seen: Pace) -> Verdict:
    saw = (
        f"the last of {count(seen.count, 'message')} arrived at {seconds(seen.gap.start)}, then nothing until "
        f"{seconds(seen.gap.end)}"
    )
    expected = _rate_expected(topic)
    return gone_silent(recording, topic, seen.gap.start, saw, expected) or failed(
        "rate.stops",
        saw,
        expected,
        "The program continues, but the publishing stops: a counter or a condition ends it, the timer is "
        "canceled, or a callback never returns.",
        "Publish on every tick of the timer, no matter what was published before.",
        about_time=True,
    )


def _skips(recording: Recording, topic: Topic, seen: Pace) -> Verdict | None:
    """A failed verdict for a silence in which other topics went on; None where the node may have been blocked."""
    going_on = [] if seen.in_bursts else others_within(recording, topic, seen.gap.start, seen.gap.end)
    if not going_on:
        return None
    if seen.gap.kind == "before":
        return failed(
            "rate.begins-late",
            f"the first message arrived after {seconds(seen.gap.seconds)}; {listing(going_on)} had started before "
            "that",
            _rate_expected(topic),
            "This topic's timer is created late, or its callback doesn't publish at first: it skips calls, or it "
            "works or sleeps before it publishes.",
            "Create the timer in __init__, and publish right away in each call of its callback.",
            about_time=True,
        )
    return _uneven(recording, topic) or failed(
        "rate.skips",
        f"a silence of {seconds(seen.gap.seconds)} after {seconds(seen.gap.start)}, while {listing(going_on)} went on",
        _rate_expected(topic),
        "The node wasn't blocked. A condition or a counter sometimes skips the publish(), or this topic's callback "
        "waits for something.",
        "Publish once in each call of the timer's callback, no matter what was published before.",
        about_time=True,
    )


def _intervals(recording: Recording, topic: Topic) -> list[float]:
    return [after.t - before.t for before, after in pairwise(recording.topic(topic.name).arrivals)]


def _all_about(intervals: list[float], typical: float, off: float = INTERVAL_TOLERANCE) -> bool:
    return all(abs(one - typical) <= off * typical for one in intervals)


def _changes(recording: Recording, topic: Topic, expected: str) -> Verdict | None:
    """A failed verdict where messages come evenly at one pace, and from a moment on evenly at another; else None."""
    intervals = _intervals(recording, topic)
    at_first = median(intervals[:LEAST_INTERVALS]) if intervals else 0.0
    same = [abs(one - at_first) <= UNEVEN * at_first for one in intervals]
    change = same.index(False) if False in same else len(same)
    before, after = intervals[:change], intervals[change + 1 :]
    if min(len(before), len(after)) < LEAST_INTERVALS or any(same[change:]):
        return None
    later = median(after)
    if not (_all_about(before, at_first) and _all_about(after, later)):
        return None
    moment = recording.topic(topic.name).arrivals[change].t
    return failed(
        "rate.changes",
        f"one message every {hertz(at_first)} s until {seconds(moment)}, then one every {hertz(later)} s",
        expected,
        "The rate changes while the program runs. The timer is re-created with another period, or from then on, a "
        "condition skips calls or adds some.",
        f"Keep one timer with a fixed period: create_timer({topic.period}, ...). Publish once in each call of its "
        "callback.",
        about_time=True,
    )


def _uneven(recording: Recording, topic: Topic) -> Verdict | None:
    """A failed verdict where many messages come too soon and many too late; None where most come in time."""
    intervals = _intervals(recording, topic)
    soon = [one for one in intervals if one < (1 - UNEVEN) * topic.period]
    late = [one for one in intervals if one > (1 + UNEVEN) * topic.period]
    if min(len(soon), len(late)) < UNEVEN * len(intervals):
        return None
    return failed(
        "rate.uneven",
        f"{seconds(min(intervals))} to {seconds(max(intervals))} from one message to the next; {len(soon)} arrived "
        f"too soon, {len(late)} too late",
        _rate_expected(topic),
        "The time between two messages changes. The timer is re-created with other periods, or the callback waits "
        "before it publishes.",
        f"Create one timer, with a fixed period: create_timer({topic.period}, ...). Publish right away in its "
        "callback.",
        about_time=True,
    )


def _falls_silent(topic: Topic, seen: Pace) -> Verdict:
    where = "before the first message" if seen.gap.kind == "before" else f"after {seconds(seen.gap.start)}"
    if seen.in_bursts:
        return failed(
            "rate.groups-with-silences",
            f"messages arrive in {_groups(seen)}, with a silence of {seconds(seen.gap.seconds)} {where}",
            _rate_expected(topic),
            "Several messages are published at the same time, and then none for a while. One callback publishes "
            "them all. Or another callback works or sleeps and blocks the node, and the timer catches up afterward.",
            f"Publish once in each call of a timer's callback: create_timer({topic.period}, ...). Keep all callbacks "
            "short, and never sleep in them.",
            about_time=True,
        )
    return failed(
        "rate.silence",
        f"a silence of {seconds(seen.gap.seconds)} {where}",
        _rate_expected(topic),
        "Something blocks the node: while one callback works or sleeps, no other timer runs. Or your code skips "
        "some messages.",
        "Keep callbacks short, never sleep in them, and publish once in each call.",
        about_time=True,
    )


def _too_few(recording: Recording, topic: Topic, seen: Pace) -> Verdict:
    saw = f"only {count(seen.count, 'message')} in {_watched_s(recording, topic)}"
    ended = program_ended(recording, saw, _rate_expected(topic))
    if ended is None and seen.gap.kind == "before" and seen.gap.seconds > FIRST_LATE_PERIODS * topic.period:
        return failed(
            "rate.first-late",
            f"{saw}, and the first arrived after {seconds(seen.gap.seconds)}",
            _rate_expected(topic),
            "The first message takes longer than one period. The callback works or sleeps before it publishes, or "
            "its timer is created late.",
            f"Let create_timer({topic.period}, ...) call the callback, publish in its first line, and never sleep in "
            "it.",
            about_time=True,
        )
    return ended or failed(
        "rate.too-few",
        saw,
        _rate_expected(topic),
        "There are too few messages to measure a rate.",
        f"Let create_timer({topic.period}, ...) call the function that publishes.",
        about_time=True,
    )


@_of_pace
@if_all_kept
def counts(recording: Recording, topic: Topic) -> Verdict:
    """As many messages arrive as there are periods in the window, give or take one at its edge."""
    assert topic.hz is not None
    seen = topic_pace(recording, topic)
    start, end = _watched(recording, topic)
    wanted = round((end - start) * topic.hz)
    if abs(seen.count - wanted) <= 1:
        return passed(f"{seen.count} messages in {seconds(end - start)}")
    if end <= start:
        return _at_one_moment(recording, topic, seen)
    hz = seen.count / (end - start)
    told = _faster(recording) if _too_fast_to_tell(recording, hz) else f"{hertz(hz)} Hz"
    saw = f"{count(seen.count, 'message')} in {seconds(end - start)} ({told})"
    expected = f"{wanted} messages: {number(topic.hz)} Hz, one every {number(topic.period)} s"
    ended = program_ended(recording, saw, expected) if seen.count < wanted else None
    return ended or _changes(recording, topic, expected) or _other_rate(recording, topic, hz, saw, expected)


@_of_pace
@if_messages
def keeps_period(recording: Recording, topic: Topic) -> Verdict:
    """The typical interval is the topic's period, within a tenth. A few messages are enough to tell.

    On simulated time, where many are watched, the mean interval is so within 4 %.
    """
    expected = f"one message every {number(topic.period)} s"
    seen = topic_pace(recording, topic)
    typical = seen.typical_interval
    if typical is None:
        return program_ended(recording, "a single message", expected) or failed(
            "keeps-period.once",
            "a single message",
            expected,
            "The message is published once, not repeatedly.",
            _try_rate(topic),
            about_time=True,
        )
    mean = 1 / seen.hz if recording.clock == "simulated" and seen.hz else topic.period
    if (
        abs(typical - topic.period) <= INTERVAL_TOLERANCE * topic.period
        and abs(mean - topic.period) <= MEAN_TOLERANCE * topic.period
    ):
        return passed(expected)
    return failed(
        "keeps-period.other-period",
        f"typically {typical:.3g} s from one message to the next",
        expected,
        "The period given to create_timer is wrong. Or a loop sleeps for a full period in addition to its work.",
        _try_rate(topic),
        about_time=True,
    )


def _rate_seen(recording: Recording, topic: Topic, seen: Pace) -> str:
    """A rate that is not tolerated, with as many digits as it takes to tell it from a tolerated one."""
    hz = seen.hz or 0.0
    low, high = _tolerated(topic)
    rounded = [float(f"{hz:.{digits}g}") for digits in (2, 3, 4)]
    told = next((one for one in rounded if not low <= one <= high), hz)
    if _too_fast_to_tell(recording, hz):
        return _faster(recording)
    return f"{told:g} Hz: one message every {hertz(1 / hz)} s ({count(seen.count, 'message')})"


def _too_fast_to_tell(recording: Recording, hz: float) -> bool:
    """Whether simulated time goes on in steps too long to measure such a rate: a timer fires once in a step at most."""
    return recording.step_s is not None and hz * recording.step_s > 0.5 + 1e-6


def _faster(recording: Recording) -> str:
    assert recording.step_s is not None
    return f"faster than {number(0.5 / recording.step_s)} Hz"


def _other_rate(recording: Recording, topic: Topic, hz: float, saw: str, expected: str) -> Verdict:
    """Why messages come at `hz` instead of the topic's rate."""
    assert topic.hz is not None

    def fail(cause: str, because: str) -> Verdict:
        return failed(cause, saw, expected, because, _try_rate(topic), about_time=True)

    can_tell = not _too_fast_to_tell(recording, hz)
    if can_tell and topic.hz != 1.0 and math.isclose(hz, 1 / topic.hz, rel_tol=0.15):
        return fail(
            "rate.period-for-frequency",
            f"Period and frequency are swapped: create_timer takes seconds, and {number(topic.hz)} as a period "
            f"means {number(1 / topic.hz)} Hz.",
        )
    if hz > topic.hz:
        how = f"too fast by a factor of {hertz(hz / topic.hz)}" if can_tell else "far too fast"
        return fail("rate.too-fast", f"That is {how}: the period given to create_timer is too short.")
    intervals = _intervals(recording, topic)
    if recording.in_lockstep and intervals and _all_about(intervals, median(intervals)):
        return fail(
            "rate.evenly-too-slow",
            "Too slow, but steady, so nothing delays the timer. Its period is too long, or only some of its calls "
            "publish.",
        )
    return fail("rate.too-slow", "Too slow: the period is too long, or a slow callback delays the timer.")


def _try_rate(topic: Topic) -> str:
    return f"{number(topic.hz or 0.0)} Hz is a period of {number(topic.period)} s: create_timer({topic.period}, ...)."
