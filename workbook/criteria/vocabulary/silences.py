"""Tells why a topic stopped: the program crashed, it ended, nothing at all comes any more, or the others go on."""

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed
from workbook.criteria.vocabulary.known_errors import failed_by_error
from workbook.criteria.vocabulary.phrasing import listing
from workbook.recording.recording import Recording

GOES_ON_PERIODS = 1.5
"""Another topic goes on if it brings a message so many periods of the silent one, or more, after its last message."""


def program_ended(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """A failed verdict that blames the end of the program, by its error if there was one; None if it runs on."""
    if recording.process.ended_by != "itself":
        return None
    blamed = failed_by_error(
        recording, f"{saw}, and an error had ended the program", expected, about_time=True
    )
    return blamed or failed(
        "silence.program-ended",
        f"{saw}, and the program had ended",
        expected,
        "The program ended by itself, so nothing was published after that.",
        "Keep the node alive with rclpy.spin(node) until Ctrl-C.",
        about_time=True,
    )


def others_that_go_on(recording: Recording, topic: Topic, since: float) -> list[str]:
    """The judged topics that bring messages long after `since` (s of robot time), when `topic` brought its last."""
    return [
        name
        for name, seen in sorted(recording.topics.items())
        if name != topic.name
        and name in recording.wanted
        and any(arrival.t > since + GOES_ON_PERIODS * topic.period for arrival in seen.arrivals)
    ]


def others_within(recording: Recording, topic: Topic, start: float, end: float) -> list[str]:
    """The other judged topics that bring messages in the middle half of a silence from `start` to `end` (s)."""
    edge = (end - start) / 4
    return [
        name
        for name, seen in sorted(recording.topics.items())
        if name != topic.name
        and name in recording.wanted
        and any(start + edge < arrival.t < end - edge for arrival in seen.arrivals)
    ]


def gone_silent(recording: Recording, topic: Topic, since: float, saw: str, expected: str) -> Verdict | None:
    """A failed verdict for a topic whose last message came at `since`; None where only this topic is judged.

    If others go on meanwhile, and the topic had followed robot time, no machine is to blame, however busy it was.
    """
    ended = program_ended(recording, saw, expected)
    if ended is not None:
        return ended
    others = [name for name in recording.wanted if name != topic.name and recording.topic(name).publishers]
    if not others:
        return None
    going_on = others_that_go_on(recording, topic, since)
    if not going_on:
        return failed(
            "silence.of-all",
            f"{saw}; nothing came on {listing(others)} after that, either",
            expected,
            "The program runs, but nothing calls its callbacks any more. One of them never returns (an endless "
            "loop, a long sleep, a wait), or the spin has ended.",
            "Let every callback return quickly: no while loop and no sleep in it. The timer calls it again.",
            about_time=True,
        )
    return failed(
        "silence.of-one",
        f"{saw}, while {listing(going_on)} went on",
        expected,
        "The program continues, but this topic is no longer published. A counter or a condition skips the "
        "publish(), or its timer is canceled or was never created. Or another callback never returns, such as one "
        f"that publishes {listing(going_on)} in a loop of its own.",
        f"Let create_timer({topic.period}, ...) call a callback that publishes each time, no matter what it "
        "published last.",
        about_time=not recording.following.get(topic.name, False),
    )
