"""Explain why a topic went silent: the program exited, all of its topics stopped, or only this topic stopped."""

from itertools import pairwise

from workbook.criteria.criterion import Topic
from workbook.criteria.rules import Words
from workbook.criteria.verdict import Verdict
from workbook.criteria.vocabulary.known_errors import AN_ERROR_ENDED_IT, failed_by_error
from workbook.criteria.vocabulary.spins import disturbs_itself
from workbook.recording.recording import Recording, TopicRecording

WORDS = Words(__file__)

GOES_ON_PERIODS = 1.5
"""Another topic goes on if it has a message more than this many periods after the silent topic's last message.

Each period is the silent topic's required period.
"""
GOES_ON_INTERVALS = 2.5
"""A topic goes on until the end if its last silence is at most this many times its longest interval."""

_PROGRAM_ENDED = WORDS.cause("silence.program-ended", ("saw", "expected"), about_time=True)
_OWN_CLOCK = WORDS.cause("no-message.own-clock", ("saw", "expected", "nodes"))
_OTHERS_SILENT = WORDS.seen("silence.all-others-silent", ("saw", "expected", "others"))
_OTHERS_STOPPED = WORDS.seen("silence.others-stopped", ("saw", "expected", "others", "last"))
_OF_ALL = WORDS.cause("silence.of-all", ("saw", "expected"), about_time=True)
_OF_ONE = WORDS.cause("silence.of-one", ("saw", "expected", "going_on", "topic"))


def program_ended(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """Return a failed verdict that blames the program's exit or the error behind it, or None if the program runs on."""
    if recording.process.ended_by != "itself":
        return None
    blamed = failed_by_error(recording, f"{saw}{AN_ERROR_ENDED_IT}", expected, about_time=True)
    return blamed or _PROGRAM_ENDED.verdict(saw=saw, expected=expected)


def ended_or_error(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """Return a failed verdict that blames the program's exit, or else the last error in its log.

    The result is None if there is neither. Feedback should name an exit before its consequences, so call this function
    before you check any other cause of missing messages.
    """
    return program_ended(recording, saw, expected) or failed_by_error(
        recording, saw, expected, about_time=True
    )


def goes_on(recording: Recording, name: str) -> bool:
    """Return whether messages kept arriving on the topic `name` until the end of the watch."""
    seen = recording.topic(name)
    times = [arrival.t for arrival in seen.arrivals]
    longest = max((after - before for before, after in pairwise(times)), default=0.0)
    end = recording.watched_s if seen.window is None else seen.window[1]
    return len(times) > 1 and end - times[-1] <= GOES_ON_INTERVALS * longest + (recording.step_s or 0.0)


def waits_for_clock(recording: Recording, topic: Topic, saw: str, expected: str) -> Verdict | None:
    """Return a failed verdict for a silent topic if its node itself subscribed to /clock, or None otherwise."""
    nodes = {publisher.node for publisher in recording.topic(topic.name).publishers}
    waiting = [node for node in recording.own_clock if node in nodes]
    return _OWN_CLOCK.verdict(saw=saw, expected=expected, nodes=waiting) if waiting else None


def other_topics(recording: Recording, topic: Topic) -> list[TopicRecording]:
    """Return the other judged topics, sorted by name."""
    names = sorted(name for name in recording.topics if name != topic.name and name in recording.wanted)
    return [recording.topics[name] for name in names]


def others_that_go_on(recording: Recording, topic: Topic, since: float) -> list[str]:
    """Return the other judged topics that go on long after `since` (simulated time, s), until the end of the watch."""
    late = since + GOES_ON_PERIODS * topic.period
    others = [one for one in other_topics(recording, topic) if any(it.t > late for it in one.arrivals)]
    return [one.name for one in others if goes_on(recording, one.name)]


def others_within(recording: Recording, topic: Topic, start: float, end: float) -> list[str]:
    """Return the other judged topics with messages in the middle half of a silence from `start` to `end` (s)."""
    edge = (end - start) / 4
    others = other_topics(recording, topic)
    return [one.name for one in others if any(start + edge < it.t < end - edge for it in one.arrivals)]


def gone_silent(recording: Recording, topic: Topic, since: float, saw: str, expected: str) -> Verdict | None:
    """Return a failed verdict for a topic whose last message arrived at `since` (simulated time, s).

    The result is None if there is no other topic to compare with, and no other explanation. If other topics go on
    although this topic followed simulated time, a busy machine can't be the cause, so the verdict isn't `about_time`.
    """
    ended = program_ended(recording, saw, expected)
    if ended is not None:
        return ended
    held = waits_for_clock(recording, topic, saw, expected) or disturbs_itself(recording, saw, expected)
    if held is not None:
        return held
    others = [name for name in recording.wanted if name != topic.name and recording.topic(name).publishers]
    if not others:
        return None
    going_on = others_that_go_on(recording, topic, since)
    if going_on:
        follows = recording.following.get(topic.name, False)
        return _OF_ONE.verdict(
            saw=saw, expected=expected, going_on=going_on, topic=topic, about_time=not follows
        )
    last = max((arrival.t for name in others for arrival in recording.topic(name).arrivals), default=since)
    told = _OTHERS_STOPPED if last > since else _OTHERS_SILENT
    saw, expected = told(saw=saw, expected=expected, others=others, last=last)
    return _OF_ALL.verdict(saw=saw, expected=expected)
