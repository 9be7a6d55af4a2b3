"""Words about a topic: is it published, under this name and type, and does anything arrive?"""

import difflib
from collections.abc import Iterable

from workbook.criteria.criterion import Topic
from workbook.criteria.mishaps import failed_by_error
from workbook.criteria.phrasing import count, listing, seconds
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.observing.recording import Recording, TopicRecording

OF_THE_DRIVER = "/driver/"
"""Topics of the program that calls a student's functions. They are not the student's."""

ALIKE = 0.6
"""From this share of common letters on, another name counts as a slip of the pen."""


def publishes(recording: Recording, topic: Topic) -> Verdict:
    """Somebody publishes `topic` with the right type."""
    seen = recording.topic(topic.name)
    expected = f"a publisher on {topic.name} of type {topic.short_type}"
    if topic.type in seen.types:
        others = [name for name in seen.types if name != topic.type]
        if others:
            return failed(
                f"{topic.name} has publishers of two types: {topic.short_type} and {listing(others)}",
                expected,
                "Two create_publisher() calls use the same topic name with different message types.",
                "Keep the one of the right type.",
            )
        return passed(f"{topic.name} carries {topic.short_type}")
    if seen.publishers:
        got = listing([name.rsplit("/", 1)[1] for name in seen.types])
        return failed(
            f"{topic.name} carries {got}",
            expected,
            f"The publisher was created with another message type than {topic.short_type}.",
            f"Import {topic.short_type} from {topic.type.split('/')[0]}.msg and give it to create_publisher().",
        )
    return _not_published(recording, topic, expected)


def _not_published(recording: Recording, topic: Topic, expected: str) -> Verdict:
    own = [other for other in recording.published() if not other.name.startswith(OF_THE_DRIVER)]
    names = [other.name for other in own]
    strange = [other for other in own if other.name not in recording.wanted]
    same_type = [other for other in strange if topic.type in other.types and other.name != topic.name]
    others = [other.name for other in strange]
    near = difflib.get_close_matches(topic.name, others, 1, 0.75)
    base = topic.name.rsplit("/", 1)[-1]
    suspect = next((name for name in others if name.rsplit("/", 1)[-1] == base), near[0] if near else None)
    if suspect is None and len(same_type) == 1 and similar_share(same_type[0].name, topic.name) > 0.5:
        suspect = same_type[0].name
    if suspect is not None:
        return failed(
            f"your node publishes {suspect}, and nothing on {topic.name}",
            expected,
            _why_other_name(recording, suspect, topic.name),
            f"Write the name as {topic.name!r}.",
        )
    blamed = failed_by_error(recording, f"nothing on {topic.name}", expected)
    if blamed is not None:
        return blamed
    return failed(
        f"nothing on {topic.name}; your program publishes {listing(names) or 'nothing'}",
        expected,
        "The publisher is not created, or under a very different name.",
        f"Call create_publisher({topic.short_type}, {topic.name!r}, 10) in __init__.",
    )


def similar_share(one: str, other: str) -> float:
    """How alike two names are, 0 to 1."""
    return difflib.SequenceMatcher(None, one, other).ratio()


def misspelled(recording: Recording, wanted: str, names: Iterable[str]) -> str | None:
    """The name that was probably meant to be `wanted`; None if none is alike enough."""
    strange = sorted(set(names).difference(recording.wanted))
    near = max(strange, key=lambda name: similar_share(name, wanted), default=None)
    return near if near is not None and similar_share(near, wanted) > ALIKE else None


def _why_other_name(recording: Recording, seen: str, wanted: str) -> str:
    if seen.lower() == wanted.lower():
        return "Topic names are case-sensitive: capital and small letters are different names."
    owners = {publisher.node for publisher in recording.topic(seen).publishers}
    if any(seen.startswith(f"{owner}/") for owner in owners):
        return "A name that begins with ~ is private: the node's own name is put in front."
    if wanted.endswith(seen):
        return f"The namespace {wanted[: -len(seen)]} is missing."
    if seen.endswith(wanted):
        return f"The node runs in the namespace {seen[: -len(wanted)]}, which is put in front of a relative name."
    return "The two names differ; ROS matches names letter by letter."


def no_message(recording: Recording, topic: Topic) -> Verdict | None:
    """A failed verdict when nothing arrived on `topic`, else None."""
    seen = recording.topic(topic.name)
    if seen.arrivals:
        return None
    window = window_of(recording, seen)
    lasted = seconds(window[1] - window[0])
    if seen.undecodable:
        return failed(
            f"{count(seen.undecodable, 'message')} on {topic.name} could not be decoded",
            f"readable {topic.short_type} messages",
            "The bytes on the wire are no message of this type.",
            "Publish message objects, not raw bytes.",
        )
    if seen.not_kept:
        return failed(
            f"{count(seen.not_kept, 'message')} on {topic.name} came, larger than 4 MB",
            f"readable {topic.short_type} messages",
            "A list that grows with every message, or far too many values.",
            "Print the length of what you publish; begin a new list for every message.",
        )
    blamed = failed_by_error(
        recording, f"no message on {topic.name} in {lasted}", f"messages on {topic.name}", about_time=True
    )
    if blamed is not None:
        return blamed
    return failed(
        f"the publisher on {topic.name} is there, but no message arrived in {lasted}",
        f"messages on {topic.name}",
        "No timer calls the function that publishes, the node does not spin, or it published only once before "
        "anybody was connected.",
        "Create a timer for it in __init__, keep it running with rclpy.spin(node), and publish inside the callback.",
        about_time=True,
    )


def window_of(recording: Recording, seen: TopicRecording) -> tuple[float, float]:
    """Begin and end (s of robot time) of the watch over a topic."""
    start, end = seen.window if seen.window is not None else (0.0, recording.robot_s)
    return start, max(start, end)
