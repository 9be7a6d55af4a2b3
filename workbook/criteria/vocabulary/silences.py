"""Tells why a topic stopped: the program crashed, it ended, nothing at all comes any more, or the others go on."""

from itertools import pairwise

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed
from workbook.criteria.vocabulary.known_errors import failed_by_error
from workbook.criteria.vocabulary.phrasing import listing, seconds
from workbook.criteria.vocabulary.spins import disturbs_itself
from workbook.recording.recording import Recording

GOES_ON_PERIODS = 1.5
"""Another topic goes on if it brings a message so many periods of the silent one, or more, after its last message."""
GOES_ON_INTERVALS = 2.5
"""It has not stopped while the time since its last message is no longer than so many of its longest intervals."""


def program_ended(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """A failed verdict that blames the end of the program, by its error if there was one; None if it runs on."""
    if recording.process.ended_by != "itself":
        return None
    blamed = failed_by_error(recording, f"{saw}; an error had ended the program", expected, about_time=True)
    return blamed or failed(
        "silence.program-ended",
        f"{saw}; the program had ended",
        expected,
        "The program ended by itself, so nothing was published after that.",
        "Keep the node alive with rclpy.spin(node) until Ctrl-C.",
        about_time=True,
    )


def ended_or_error(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """A failed verdict that blames the end of the program, or else the last error in its log; None if there is neither.

    An end is named before its consequences: use this before any cause that a program without messages suggests.
    """
    return program_ended(recording, saw, expected) or failed_by_error(
        recording, saw, expected, about_time=True
    )


def goes_on(recording: Recording, name: str) -> bool:
    """Whether a topic brings messages until the end of the watch."""
    seen = recording.topic(name)
    times = [arrival.t for arrival in seen.arrivals]
    longest = max((after - before for before, after in pairwise(times)), default=0.0)
    end = recording.simulated_s if seen.window is None else seen.window[1]
    return len(times) > 1 and end - times[-1] <= GOES_ON_INTERVALS * longest + (recording.step_s or 0.0)


def waits_for_clock(recording: Recording, topic: Topic, saw: str, expected: str) -> Verdict | None:
    """A failed verdict for a silent topic of a node that subscribed to /clock by itself; None for any other."""
    nodes = {publisher.node for publisher in recording.topic(topic.name).publishers}
    waiting = [node for node in recording.own_clock if node in nodes]
    if not waiting:
        return None
    return failed(
        "no-message.own-clock",
        f"{saw}; {listing(waiting)} subscribes to /clock",
        expected,
        "The node has use_sim_time set to true, so its timers wait for messages on /clock. No node publishes "
        "/clock here, just as when you run the program yourself.",
        "Remove the line that sets use_sim_time. A simulator sets this parameter where there is one.",
    )


def others_that_go_on(recording: Recording, topic: Topic, since: float) -> list[str]:
    """The judged topics that bring messages long after `since` (s, simulated), and until the end of the watch."""
    return [
        name
        for name, seen in sorted(recording.topics.items())
        if name != topic.name
        and name in recording.wanted
        and any(arrival.t > since + GOES_ON_PERIODS * topic.period for arrival in seen.arrivals)
        and goes_on(recording, name)
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


def _when_others_stopped(recording: Recording, others: list[str], since: float) -> str:
    last = max((arrival.t for name in others for arrival in recording.topic(name).arrivals), default=since)
    if last <= since:
        return f"nothing arrived on {listing(others)} after that, either"
    return f"the last message on {listing(others)} arrived at {seconds(last)}"


def gone_silent(recording: Recording, topic: Topic, since: float, saw: str, expected: str) -> Verdict | None:
    """A failed verdict for a topic whose last message came at `since`; None where only this topic is judged.

    If others go on meanwhile, and the topic had followed simulated time, no machine is to blame, however busy it was.
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
    if not going_on:
        return failed(
            "silence.of-all",
            f"{saw}; {_when_others_stopped(recording, others, since)}",
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
