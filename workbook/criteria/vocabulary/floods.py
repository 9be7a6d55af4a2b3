"""Explain why a topic has far too many messages: they're published without a pause, or at a growing rate."""

from itertools import pairwise

from workbook.criteria.criterion import Topic
from workbook.criteria.rules import Words
from workbook.criteria.verdict import Verdict
from workbook.recording.limits import FLOOD_MESSAGES, FLOOD_S
from workbook.recording.recording import Recording

WORDS = Words(__file__)

PARTS = 4
LEAST = 8
TOO_MANY = 1.5
"""Growth is judged only if more messages arrive than this many times the number due, and at least `LEAST`."""
FEW_AT_FIRST = 50
"""Growth is judged only if at most this many messages arrive in the topic's first period."""
GROWS = 3.0
"""A topic's rate grows if the last of `PARTS` parts has at least this many times the messages of the first part."""

_GROWS = WORDS.cause("rate.grows", ("expected", "counts", "part_s"), about_time=True)
_WITHOUT_A_PAUSE = WORDS.cause(
    "rate.without-a-pause", ("expected", "count", "within_s", "began", "topic"), about_time=True
)


def flood(recording: Recording, topic: Topic, expected: str) -> Verdict | None:
    """Return a failed verdict for a topic that floods its subscribers, or None for any other topic."""
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
    return _GROWS.verdict(expected=expected, counts=", then ".join(map(str, counts)), part_s=part_s)


def _without_a_pause(times: list[float], topic: Topic, expected: str) -> Verdict | None:
    pairs = zip(times, times[FLOOD_MESSAGES - 1 :], strict=False)
    began = next((first for first, last in pairs if last - first < FLOOD_S), None)
    if began is None:
        return None
    in_a_second = sum(began <= t < began + FLOOD_S for t in times)
    return _WITHOUT_A_PAUSE.verdict(
        expected=expected, count=in_a_second, within_s=FLOOD_S, began=began, topic=topic
    )
