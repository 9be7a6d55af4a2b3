"""Judges a topic: whether it is published, under this name and type, and whether messages arrive."""

import difflib
from collections.abc import Callable, Iterable
from functools import wraps
from typing import Concatenate, ParamSpec

from workbook.criteria.criterion import CriterionFunction, Topic
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.known_errors import failed_by_error
from workbook.criteria.vocabulary.phrasing import count, listing, seconds
from workbook.criteria.vocabulary.silences import goes_on, program_ended, waits_for_clock
from workbook.criteria.vocabulary.spins import held_by_a_spin
from workbook.recording.recording import Recording, TopicRecording

OF_THE_DRIVER = "/driver/"
"""Topics of the program that calls a student's functions. They are not the student's."""

ALIKE = 0.6
"""From this share of common letters on, another name counts as a slip of the pen."""

P = ParamSpec("P")


def publishes(recording: Recording, topic: Topic) -> Verdict:
    """Something publishes `topic` with the right type, and nothing publishes it with another."""
    seen = recording.topic(topic.name)
    expected = f"a publisher on {topic.name} of type {topic.short_type}"
    if topic.type in seen.types:
        others = [name for name in seen.types if name != topic.type]
        if others:
            return failed(
                "publishes.two-types",
                f"{topic.name} has publishers of two types: {topic.short_type} and {listing(others)}",
                expected,
                "Two create_publisher() calls use the same topic name with different message types.",
                f"Keep only the publisher of type {topic.short_type}.",
            )
        return passed(f"{topic.name} carries {topic.short_type}")
    if seen.publishers:
        got = listing([name.rsplit("/", 1)[1] for name in seen.types])
        return failed(
            "publishes.other-type",
            f"{topic.name} carries {got}",
            expected,
            f"The publisher was created with a message type other than {topic.short_type}.",
            f"Import {topic.short_type} from {topic.type.split('/')[0]}.msg and give it to create_publisher().",
        )
    return _not_published(recording, topic, expected)


def _not_published(recording: Recording, topic: Topic, expected: str) -> Verdict:
    own = [other for other in recording.with_publishers() if not other.name.startswith(OF_THE_DRIVER)]
    meant = _meant_to_be(topic, [other for other in own if other.name not in recording.wanted])
    if meant is not None:
        return _under_other_name(recording, meant, topic.name, expected)
    blamed = failed_by_error(recording, f"nothing on {topic.name}", expected)
    if blamed is not None:
        return blamed
    names = [other.name for other in own]
    held = held_by_a_spin(recording, f"nothing on {topic.name}", expected)
    return held or failed(
        "publishes.nothing",
        f"nothing on {topic.name}; your program publishes {listing(names) or 'nothing'}",
        expected,
        "The publisher isn't created, or its topic has a very different name.",
        f"Call create_publisher({topic.short_type}, {topic.name!r}, 10) in __init__.",
    )


def _meant_to_be(topic: Topic, strange: list[TopicRecording]) -> str | None:
    """The name, of topics that no right program has, that was probably meant to be this topic's."""
    others = [other.name for other in strange]
    near = difflib.get_close_matches(topic.name, others, 1, 0.75)
    base = topic.name.rsplit("/", 1)[-1]
    suspect = next((name for name in others if name.rsplit("/", 1)[-1] == base), near[0] if near else None)
    same_type = [other for other in strange if topic.type in other.types and other.name != topic.name]
    if suspect is None and len(same_type) == 1 and similar_share(same_type[0].name, topic.name) > 0.5:
        return same_type[0].name
    return suspect


def similar_share(one: str, other: str) -> float:
    """How alike two names are, 0 to 1."""
    return difflib.SequenceMatcher(None, one, other).ratio()


def misspelled(recording: Recording, wanted: str, names: Iterable[str]) -> str | None:
    """The name that was probably meant to be `wanted`; None if none is alike enough."""
    strange = sorted(set(names).difference(recording.wanted))
    near = max(strange, key=lambda name: similar_share(name, wanted), default=None)
    return near if near is not None and similar_share(near, wanted) > ALIKE else None


def _under_other_name(recording: Recording, seen: str, wanted: str, expected: str) -> Verdict:
    def fail(cause: str, because: str) -> Verdict:
        saw = f"your node publishes {seen}, but nothing on {wanted}"
        return failed(cause, saw, expected, because, f"Write the name as {wanted!r}.")

    if seen.lower() == wanted.lower():
        return fail(
            "publishes.other-case",
            "Topic names are case-sensitive: a capital letter makes a different name.",
        )
    owners = {publisher.node for publisher in recording.topic(seen).publishers}
    if any(wanted.endswith(seen.removeprefix(owner)) for owner in owners if seen.startswith(f"{owner}/")):
        return fail(
            "publishes.private-name",
            "A name that begins with ~ is private: ROS puts the node's own name in front.",
        )
    if wanted.endswith(seen):
        return fail("publishes.no-namespace", f"The namespace {wanted[: -len(seen)]} is missing.")
    if seen.endswith(wanted):
        return fail(
            "publishes.other-namespace",
            f"The node runs in the namespace {seen[: -len(wanted)]}, which ROS puts in front of a relative name.",
        )
    return fail("publishes.other-name", "The two names differ. ROS compares names letter by letter.")


def no_message(recording: Recording, topic: Topic) -> Verdict | None:
    """A failed verdict when nothing arrived on `topic`, otherwise None."""
    seen = recording.topic(topic.name)
    if seen.arrivals:
        return None
    if seen.undecodable:
        return failed(
            "no-message.undecodable",
            f"{count(seen.undecodable, 'message')} on {topic.name} could not be decoded",
            f"readable {topic.short_type} messages",
            "The bytes that were sent are not a message of this type.",
            "Publish message objects, not raw bytes.",
        )
    if seen.not_kept and seen.full_at is None:
        return failed(
            "no-message.too-large",
            f"{count(seen.not_kept, 'message')} on {topic.name}, larger than 4 MB",
            f"readable {topic.short_type} messages",
            "The message contains a list that grows with every message, or far too many values.",
            "Print the length of the data that you publish, and create a new list for every message.",
        )
    return _more_than_is_kept(recording, topic) or _silent(recording, topic)


def _silent(recording: Recording, topic: Topic) -> Verdict:
    start, end = window_of(recording, recording.topic(topic.name))
    lasted = seconds(end - start)
    nothing, expected = f"no message on {topic.name} in {lasted}", f"messages on {topic.name}"
    ended = failed_by_error(recording, nothing, expected, about_time=True) or program_ended(
        recording, nothing, expected
    )
    if ended is not None:
        return ended
    saw = f"the publisher on {topic.name} is there, but no message arrived in {lasted}"
    waiting = waits_for_clock(recording, topic, saw, expected)
    if waiting is not None:
        return waiting
    others = _arrive_from_its_node(recording, topic)
    held = held_by_a_spin(recording, saw, expected, of_a_spun_node=bool(others))
    if held is not None:
        return held
    if others:
        return _silent_beside(recording, topic, others, saw)
    return failed(
        "no-message.silent",
        saw,
        expected,
        "No timer calls the function that publishes, or nothing spins the node. Or the node published only once, "
        "before a subscription was connected.",
        "Create a timer in __init__, publish in its callback, and keep the node running with rclpy.spin(node).",
        about_time=True,
    )


def _arrive_from_its_node(recording: Recording, topic: Topic) -> list[str]:
    """The other topics of the exercise that the node of this one publishes, and that bring messages."""
    nodes = {publisher.node for publisher in recording.topic(topic.name).publishers}
    return [
        name
        for name, seen in sorted(recording.topics.items())
        if name != topic.name
        and name in recording.wanted
        and len(seen.arrivals) > 1
        and nodes & {publisher.node for publisher in seen.publishers}
    ]


def _silent_beside(recording: Recording, topic: Topic, others: list[str], saw: str) -> Verdict:
    """The verdict on a silent topic of a node whose `others` arrive, to the end or until it stopped."""
    going_on = [name for name in others if goes_on(recording, name)]
    if not going_on:
        last = max(recording.topic(name).arrivals[-1].t for name in others)
        return failed(
            "no-message.all-stopped",
            f"{saw}; the last message on {listing(others)} arrived at {seconds(last)}",
            f"messages on {topic.name}",
            "The node published something and then stopped, before this topic had its turn. One of its callbacks "
            "never returns, or nothing spins the node any more.",
            "Find out why everything stops. Look at the last callback that was called: what does it wait for?",
            about_time=True,
        )
    timer = f"Let create_timer({topic.period}, ...), which takes seconds, call" if topic.hz else "Call"
    return failed(
        "no-message.silent-beside-others",
        f"{saw}, while {listing(going_on)} went on",
        f"messages on {topic.name}",
        "The node works, but nothing is published here. Nothing calls the function that publishes, it uses the "
        "publisher of another topic, or its timer's period is far too long. Or it published only once, before a "
        "subscription was connected.",
        f"{timer} a function that publishes with the publisher of {topic.name}.",
        about_time=True,
    )


def if_messages(
    word: Callable[Concatenate[Recording, Topic, P], Verdict],
) -> Callable[Concatenate[Recording, Topic, P], Verdict]:
    """Decorates a function that judges a topic's messages: where none arrived, the verdict is that of `no_message`."""

    @wraps(word)
    def judge(recording: Recording, topic: Topic, /, *args: P.args, **kwargs: P.kwargs) -> Verdict:
        return no_message(recording, topic) or word(recording, topic, *args, **kwargs)

    return judge


def if_all_kept(
    word: Callable[Concatenate[Recording, Topic, P], Verdict],
) -> Callable[Concatenate[Recording, Topic, P], Verdict]:
    """Decorates a function that judges each message of a topic, of which some must have arrived.

    Messages that nobody can read count as well: beside right ones they are a failure. So is it where more came than is
    kept, unless what is kept fails by itself.
    """

    @wraps(word)
    def judge(recording: Recording, topic: Topic, /, *args: P.args, **kwargs: P.kwargs) -> Verdict:
        broken = no_message(recording, topic) or _some_are_broken(recording, topic)
        if broken is not None:
            return broken
        verdict = word(recording, topic, *args, **kwargs)
        return (_more_than_is_kept(recording, topic) if verdict.ok else None) or verdict

    return judge


def _some_are_broken(recording: Recording, topic: Topic) -> Verdict | None:
    seen = recording.topic(topic.name)
    since = "" if seen.broken_at is None else f", the first at {seconds(seen.broken_at)}"
    right = count(len(seen.arrivals), "readable message")
    expected = f"{topic.short_type} messages that can be read, and no others"
    if seen.undecodable:
        return failed(
            "all-kept.undecodable",
            f"{right} on {topic.name}, but also {seen.undecodable} that could not be decoded{since}",
            expected,
            "The bytes on the wire are not a message of this type.",
            "Publish message objects only, not raw bytes.",
        )
    if seen.too_large:
        return failed(
            "all-kept.too-large",
            f"{right} on {topic.name}, but also {seen.too_large} larger than 4 MB{since}",
            expected,
            "The message contains a list that grows with every message, or far too many values.",
            "Print the length of the data that you publish, and create a new list for every message.",
        )
    return None


def _more_than_is_kept(recording: Recording, topic: Topic) -> Verdict | None:
    seen = recording.topic(topic.name)
    if seen.full_at is None:
        return None
    start, _ = window_of(recording, seen)
    lasted = seconds(max(0.0, seen.full_at - start))
    kept = count(len(seen.arrivals), "message")
    room = kept if seen.room is None else f"{seen.room / 1e6:g} MB"
    return failed(
        "all-kept.too-much",
        f"the messages on {topic.name} exceeded the judge's limit for a topic ({room}) after {lasted} and {kept}; "
        "the judge ignored the rest",
        f"at most {room} on {topic.name}",
        "The messages are far larger than the task asks for, or there are far more of them: a list grows, or a "
        "loop publishes.",
        "Print the length of the data that you publish, and how often you publish it.",
    )


def needs_messages(topic: Topic) -> Callable[[CriterionFunction], CriterionFunction]:
    """Decorates a judging function: where no message arrived on `topic`, the verdict is that of `no_message`."""

    def guard(function: CriterionFunction) -> CriterionFunction:
        @wraps(function)
        def judge(recording: Recording) -> Verdict:
            return no_message(recording, topic) or function(recording)

        return judge

    return guard


def window_of(recording: Recording, seen: TopicRecording) -> tuple[float, float]:
    """Begin and end (s of simulated time) of the watch over a topic."""
    start, end = seen.window if seen.window is not None else (0.0, recording.simulated_s)
    return start, max(start, end)
