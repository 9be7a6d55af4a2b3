"""Judges what a program subscribes to."""

import re

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.known_errors import failed_by_error
from workbook.criteria.vocabulary.phrasing import listing
from workbook.criteria.vocabulary.spins import held_by_a_spin
from workbook.criteria.vocabulary.topics import misspelled
from workbook.recording.recording import Recording

OTHER_QOS = re.compile(r"publisher discovered on topic '([^']+)', offering incompatible QoS.*policy: (\w+)")


def asks_for_other_qos(recording: Recording, name: str, saw: str, expected: str) -> Verdict | None:
    """A failed verdict where rclpy logged incompatible QoS for a subscription to topic `name`; None otherwise."""
    policy = next((said for topic, said in OTHER_QOS.findall(recording.process.log) if topic == name), None)
    if policy is None:
        return None
    return failed(
        "listens.other-qos",
        f"{saw}; rclpy logged incompatible QoS for {name}: {policy}",
        expected,
        f"The subscription requests QoS that the publisher doesn't offer, so no message on {name} arrives.",
        "Give create_subscription() a plain queue depth, such as 10, instead of a QoSProfile.",
    )


def _under_other_name(recording: Recording, near: str, wanted: str, expected: str) -> Verdict:
    saw, write = f"your node subscribes to {near}, not to {wanted}", f"Write the name as {wanted!r}."
    if any(near.startswith(f"{subscriber.node}/") for subscriber in recording.topic(near).subscribers):
        because = "A name that begins with ~ is private: the node's own name is put in front."
        return failed("listens.private-name", saw, expected, because, write)
    because = "The two names differ. ROS compares names letter by letter."
    return failed("listens.other-name", saw, expected, because, write)


def listens(recording: Recording, topic: Topic) -> Verdict:
    """The program subscribes to `topic` with the right type."""
    seen = recording.topic(topic.name)
    expected = f"a subscription to {topic.name} of type {topic.short_type}"
    types = sorted({subscriber.type for subscriber in seen.subscribers})
    if topic.type in types:
        return passed(f"subscribes to {topic.name}")
    if types:
        got = listing([name.rsplit("/", 1)[1] for name in types])
        return failed(
            "listens.other-type",
            f"a subscription to {topic.name} for {got}",
            expected,
            "The subscription was created with another message type.",
            f"Import {topic.short_type} from {topic.type.split('/')[0]}.msg and give it to create_subscription().",
        )
    blamed = failed_by_error(recording, f"nothing subscribes to {topic.name}", expected)
    if blamed is not None:
        return blamed
    near = misspelled(
        recording, topic.name, [name for name, other in recording.topics.items() if other.subscribers]
    )
    if near is not None:
        return _under_other_name(recording, near, topic.name, expected)
    return held_by_a_spin(recording, f"nothing subscribes to {topic.name}", expected) or failed(
        "listens.nothing",
        f"nothing subscribes to {topic.name}",
        expected,
        "No create_subscription() call was reached.",
        f"Call create_subscription({topic.short_type}, {topic.name!r}, self.on_message, 10) in __init__.",
    )
