"""Judge a program's subscriptions."""

import re

from workbook.criteria.criterion import Topic
from workbook.criteria.rules import Words
from workbook.criteria.verdict import Verdict, passed
from workbook.criteria.vocabulary.known_errors import failed_by_error
from workbook.criteria.vocabulary.spins import held_by_a_spin
from workbook.criteria.vocabulary.topics import misspelled
from workbook.recording.recording import Recording

WORDS = Words(__file__)

OTHER_QOS = re.compile(r"publisher discovered on topic '([^']+)', offering incompatible QoS.*policy: (\w+)")
_OTHER_QOS = WORDS.cause("listens.other-qos", ("saw", "expected", "name", "policy"))
_OTHER_TYPE = WORDS.cause("listens.other-type", ("topic", "types"))
_NOTHING = WORDS.cause("listens.nothing", ("topic",))
_PRIVATE_NAME = WORDS.cause("listens.private-name", ("topic", "near"))
_OTHER_NAME = WORDS.cause("listens.other-name", ("topic", "near"))


def asks_for_other_qos(recording: Recording, name: str, saw: str, expected: str) -> Verdict | None:
    """Return a failed verdict if rclpy logged incompatible QoS for a subscription to `name`, or None otherwise."""
    policy = next((said for topic, said in OTHER_QOS.findall(recording.process.log) if topic == name), None)
    if policy is None:
        return None
    return _OTHER_QOS.verdict(saw=saw, expected=expected, name=name, policy=policy)


def listens(recording: Recording, topic: Topic) -> Verdict:
    """Check that the program subscribes to `topic` with the right type."""
    seen = recording.topic(topic.name)
    types = sorted({subscriber.type for subscriber in seen.subscribers})
    if topic.type in types:
        return passed(f"subscribes to {topic.name}")
    if types:
        return _OTHER_TYPE.verdict(topic=topic, types=[name.rsplit("/", 1)[1] for name in types])
    nothing = _NOTHING.verdict(topic=topic)
    blamed = failed_by_error(recording, nothing.saw, nothing.expected)
    if blamed is not None:
        return blamed
    listened_to = [name for name, other in recording.topics.items() if other.subscribers]
    near = misspelled(recording, topic.name, listened_to)
    if near is None:
        return held_by_a_spin(recording, nothing.saw, nothing.expected) or nothing
    is_private = any(near.startswith(f"{one.node}/") for one in recording.topic(near).subscribers)
    return (_PRIVATE_NAME if is_private else _OTHER_NAME).verdict(topic=topic, near=near)
