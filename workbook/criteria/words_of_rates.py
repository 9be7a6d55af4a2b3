"""Words about time: rates, counts and periods of a topic."""

import math

from workbook.criteria.criterion import Topic
from workbook.criteria.estimators import Pace, pace
from workbook.criteria.phrasing import count, hertz, number, seconds
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.words_of_topics import no_message, window_of
from workbook.observing.recording import Recording

RATE_TOLERANCE = 0.2
LONGEST_GAP_PERIODS = 1.5
INTERVAL_TOLERANCE = 0.1
LEAST_INTERVALS = 3


def topic_pace(recording: Recording, topic: Topic) -> Pace:
    """How the messages of `topic` are spread over its window, in robot time."""
    seen = recording.topic(topic.name)
    start, end = window_of(recording, seen)
    return pace([arrival.t for arrival in seen.arrivals], start, end, topic.period)


def rate(recording: Recording, topic: Topic) -> Verdict:
    """Messages come at the topic's rate: mean within 20 %, no silence longer than one and a half periods."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    assert topic.hz is not None
    seen = topic_pace(recording, topic)
    window = window_of(recording, recording.topic(topic.name))
    low, high = topic.hz * (1 - RATE_TOLERANCE), topic.hz * (1 + RATE_TOLERANCE)
    expected = (
        f"{number(topic.hz)} Hz: one message every {number(topic.period)} s "
        f"({number(low)} to {number(high)} Hz, no gap over {number(LONGEST_GAP_PERIODS * topic.period)} s)"
    )

    def fail(saw: str, because: str, try_this: str) -> Verdict:
        return failed(saw, expected, because, try_this, about_time=True)

    if seen.hz is None:
        once = (
            "one single message" if seen.count == 1 else f"{seen.count} messages at one moment, and no other"
        )
        return fail(
            f"{once} in {seconds(window[1] - window[0])}",
            "It is published once, or far too rarely.",
            f"Create a timer for it: publish in a callback, and let create_timer({topic.period}, ...) call it.",
        )
    gap_limit = LONGEST_GAP_PERIODS * topic.period
    hz = seen.hz
    if seen.in_bursts and hz > high:
        groups = "pairs" if seen.burst == 2 else f"groups of {seen.burst}"
        return fail(
            f"{hertz(hz)} Hz: messages come in {groups}",
            "Two timers call the same function, two publishers share the topic, or one callback publishes twice.",
            "Keep one timer and one publish() for this topic.",
        )
    stopped_s = max(gap_limit, LONGEST_GAP_PERIODS * (seen.typical_interval or 0.0))
    if seen.gap.kind == "after" and seen.gap.seconds > stopped_s:
        return fail(
            f"the last of {count(seen.count, 'message')} came at {seconds(seen.gap.start)}, "
            f"then nothing until {seconds(seen.gap.end)}",
            "The publishing stops: a counter runs out, an exception ends the callback, or the program has ended.",
            "Publish on every tick of the timer and look into the log for an error.",
        )
    if not low <= hz <= high:
        return fail(_rate_seen(recording, seen, hz), _why_rate(topic, hz), _try_rate(topic))
    if seen.gap.seconds > gap_limit + (recording.step_s or 0.0):
        where = (
            "before the first message" if seen.gap.kind == "before" else f"after {seconds(seen.gap.start)}"
        )
        return fail(
            f"a silence of {seconds(seen.gap.seconds)} {where}",
            "Something blocks: while one callback works or sleeps, no other timer of the node runs. "
            "Or several messages are published at once, and then none for a while.",
            "Keep callbacks short, never sleep in one, and publish once in each.",
        )
    if seen.count <= LEAST_INTERVALS:
        return fail(
            f"only {count(seen.count, 'message')} in {seconds(window[1] - window[0])}",
            "Too few to tell a rate.",
            f"Let create_timer({topic.period}, ...) call the function that publishes.",
        )
    return passed(f"{hertz(hz)} Hz over {count(seen.count, 'message')}")


def counts(recording: Recording, topic: Topic) -> Verdict:
    """Exactly as many messages as periods in the window; one more or less may fall on its edge."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    assert topic.hz is not None
    seen = topic_pace(recording, topic)
    start, end = window_of(recording, recording.topic(topic.name))
    wanted = round((end - start) * topic.hz)
    if abs(seen.count - wanted) <= 1:
        return passed(f"{seen.count} messages in {seconds(end - start)}")
    hz = seen.count / (end - start)
    return failed(
        f"{count(seen.count, 'message')} in {seconds(end - start)} ({hertz(hz)} Hz)",
        f"{wanted} messages: {number(topic.hz)} Hz, one every {number(topic.period)} s",
        _why_rate(topic, hz),
        _try_rate(topic),
        about_time=True,
    )


def keeps_period(recording: Recording, topic: Topic) -> Verdict:
    """The typical interval is the topic's period, within a tenth: exact also where few messages were watched."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    typical = topic_pace(recording, topic).typical_interval
    if typical is not None and abs(typical - topic.period) <= INTERVAL_TOLERANCE * topic.period:
        return passed(f"one message every {number(topic.period)} s")
    return failed(
        "one single message"
        if typical is None
        else f"typically {typical:.3g} s from one message to the next",
        f"one message every {number(topic.period)} s",
        "It is published once, not again and again."
        if typical is None
        else "The period given to create_timer is near the right one, but not the right one; or a loop sleeps for the "
        "period and takes the time of its work on top.",
        _try_rate(topic),
        about_time=True,
    )


def _rate_seen(recording: Recording, seen: Pace, hz: float) -> str:
    if recording.step_s is not None and hz > 0.5 / recording.step_s:
        return f"faster than {number(0.5 / recording.step_s)} Hz"
    return f"{hertz(hz)} Hz: one message every {hertz(1 / hz)} s ({count(seen.count, 'message')})"


def _why_rate(topic: Topic, hz: float) -> str:
    assert topic.hz is not None
    if topic.hz != 1.0 and math.isclose(hz, 1 / topic.hz, rel_tol=0.15):
        return (
            f"Period and frequency are mixed up: create_timer takes seconds, and {number(topic.hz)} as a period "
            f"means {number(1 / topic.hz)} Hz."
        )
    if hz > topic.hz:
        times = hz / topic.hz
        return (
            f"That is too fast by a factor of {hertz(times)}: the period given to create_timer is too short."
        )
    return "Too slow: the period is too long, or a slow callback holds up the timer."


def _try_rate(topic: Topic) -> str:
    return f"{number(topic.hz or 0.0)} Hz is a period of {number(topic.period)} s: create_timer({topic.period}, ...)."
