"""Explains topics that bring far too many messages: without a pause, or more and more of them."""

from itertools import pairwise

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed
from workbook.criteria.vocabulary.phrasing import count, number, seconds
from workbook.recording.limits import FLOOD_MESSAGES, FLOOD_S
from workbook.recording.recording import Recording

PARTS = 4
LEAST = 8
TOO_MANY = 1.5
"""Times as many messages as are due, and at least `LEAST`: fewer show no growth."""
FEW_AT_FIRST = 50
"""A topic that grows begins with no more messages in its first period."""
GROWS = 3.0
"""And brings at least so many times as many messages in the last part of its time as in the first."""


def flood(recording: Recording, topic: Topic, expected: str) -> Verdict | None:
    """A failed verdict for a topic that floods its listeners; None for any other."""
    times = [arrival.t for arrival in recording.topic(topic.name).arrivals]
    return _grows(times, topic, expected) or _without_a_pause(times, topic, expected)


def _grows(times: list[float], topic: Topic, expected: str) -> Verdict | None:
    if len(times) < LEAST or sum(t - times[0] < topic.period for t in times) > FEW_AT_FIRST:
        return None
    lasted = times[-1] - times[0]
    if not lasted or len(times) <= TOO_MANY * (lasted / topic.period + 1):
        return None
    part_s = lasted / PARTS
    counts = [
        sum(min(int((t - times[0]) / part_s), PARTS - 1) == part for t in times) for part in range(PARTS)
    ]
    if counts[-1] < GROWS * counts[0] or not all(before < after for before, after in pairwise(counts)):
        return None
    return failed(
        "rate.grows",
        f"more and more messages: {', then '.join(map(str, counts))}, in {seconds(part_s)} each",
        expected,
        "Each call leads to one more call, because a callback creates a timer, or a subscription to the topic that "
        "it publishes.",
        "Create timers and subscriptions in __init__ only, never in a callback.",
        about_time=True,
    )


def _without_a_pause(times: list[float], topic: Topic, expected: str) -> Verdict | None:
    pairs = zip(times, times[FLOOD_MESSAGES - 1 :], strict=False)
    began = next((first for first, last in pairs if last - first < FLOOD_S), None)
    if began is None:
        return None
    in_a_second = sum(began <= t < began + FLOOD_S for t in times)
    return failed(
        "rate.without-a-pause",
        f"{count(in_a_second, 'message')} within {number(FLOOD_S)} s, from {seconds(began)} on",
        expected,
        "There's no pause between messages. The period given to create_timer is 0 s or close to it: for example, 1 "
        "// 5 is 0, because // drops the fraction. Or a loop publishes without waiting.",
        f"Print the period that you give to create_timer: it must be {number(topic.period)} s. Let only that timer "
        "publish.",
        about_time=True,
    )
