"""Judge quality of service: whether a subscription matches its publisher, and whether late joiners get a message."""

from dataclasses import dataclass

from workbook.criteria.criterion import Topic
from workbook.criteria.rules import Words
from workbook.criteria.verdict import Verdict, passed
from workbook.criteria.vocabulary.phrasing import number
from workbook.criteria.vocabulary.subscriptions import listens
from workbook.criteria.vocabulary.topics import publishes
from workbook.recording.recording import Recording, SubscriberSeen
from workbook.recording.script import Publishes

WORDS = Words(__file__)

LONG_ENOUGH_S = 3600.0
"""A lifespan (s) of at least one hour is long enough for late subscriptions."""


@dataclass(frozen=True)
class _Request:
    """The QoS that a subscription requests, and the QoS that the script's publisher offers."""

    asked: SubscriberSeen
    offered: Publishes

    @property
    def offer(self) -> str:
        offered = self.offered
        reliability = "best effort" if offered.qos == "best_effort" else "reliable"
        durability = "transient local" if offered.qos == "latched" else "volatile"
        deadline = (
            "no deadline" if offered.deadline is None else f"a deadline of {number(offered.deadline)} s"
        )
        return f"{reliability}, {durability}, {deadline}"


_CLASH = WORDS.rules(
    _Request,
    "hears",
    ("reliable", lambda one: one.asked.reliability == "reliable" and one.offered.qos == "best_effort"),
    (
        "transient-local",
        lambda one: one.asked.durability == "transient_local" and one.offered.qos != "latched",
    ),
    ("deadline-not-offered", lambda one: one.asked.deadline is not None and one.offered.deadline is None),
    (
        "deadline-too-short",
        lambda one: one.asked.deadline is not None and one.asked.deadline < (one.offered.deadline or 0.0),
    ),
)


_VOLATILE = WORDS.cause("kept-for-latecomers.volatile", ("topic", "durability"))
_BEST_EFFORT = WORDS.cause("kept-for-latecomers.best-effort", ("topic",))
_LIFESPAN = WORDS.cause("kept-for-latecomers.lifespan", ("topic", "lifespan"))
_NOT_DELIVERED = WORDS.cause("kept-for-latecomers.not-delivered", ("topic",))


def hears(recording: Recording, offered: Publishes) -> Verdict:
    """Check that the program subscribes to the topic of `offered`, a part of the script, with the right type and QoS.

    The subscription's QoS must be compatible with the QoS that the script's publisher offers.
    """
    topic = Topic(offered.topic, offered.type)
    listening = listens(recording, topic)
    if not listening.ok:
        return listening
    seen = recording.topic(topic.name).subscribers
    clashes = [_CLASH.first(_Request(one, offered)) for one in seen if one.type == topic.type]
    compatible = passed(f"subscribes to {topic.name} with compatible QoS")
    return compatible if None in clashes else clashes[0] or compatible


def kept_for_latecomers(recording: Recording, topic: Topic) -> Verdict:
    """Check that every publisher on `topic` keeps its last message for late subscriptions.

    Each publisher must be reliable and transient local, and its lifespan, if any, must be at least `LONG_ENOUGH_S`. If
    the judge created a late subscription after the watch, that subscription must also have received a message.
    """
    published = publishes(recording, topic)
    if not published.ok:
        return published
    seen = recording.topic(topic.name)
    for one in seen.publishers:
        if one.durability != "transient_local":
            return _VOLATILE.verdict(topic=topic, durability=one.durability.replace("_", " "))
        if one.reliability != "reliable":
            return _BEST_EFFORT.verdict(topic=topic)
    for one in seen.publishers:
        if one.lifespan is not None and one.lifespan < LONG_ENOUGH_S:
            return _LIFESPAN.verdict(topic=topic, lifespan=one.lifespan)
    return (
        _NOT_DELIVERED.verdict(topic=topic)
        if seen.kept == 0
        else passed(f"{topic.name} is kept for late joiners")
    )
