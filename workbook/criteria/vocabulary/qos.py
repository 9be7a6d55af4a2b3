"""Judges quality of service: whether a subscription is compatible with its publisher, and whether a message is kept."""

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.phrasing import number
from workbook.criteria.vocabulary.subscriptions import listens
from workbook.criteria.vocabulary.topics import publishes
from workbook.recording.recording import Recording, SubscriberSeen
from workbook.recording.script import Publishes

LONG_ENOUGH_S = 3600.0
"""A message that is kept for an hour or longer is kept for those who come later."""


def hears(recording: Recording, offered: Publishes) -> Verdict:
    """The program subscribes to the script's topic with the right type and a QoS compatible with the one offered."""
    topic = Topic(offered.topic, offered.type)
    listening = listens(recording, topic)
    if not listening.ok:
        return listening
    seen = recording.topic(topic.name).subscribers
    clashes = [_clash(one, offered) for one in seen if one.type == topic.type]
    if all(clash is not None for clash in clashes) and clashes[0] is not None:
        return clashes[0]
    return passed(f"subscribes to {topic.name} with compatible QoS")


def _offer(offered: Publishes) -> str:
    reliability = "best effort" if offered.qos == "best_effort" else "reliable"
    durability = "transient local" if offered.qos == "latched" else "volatile"
    deadline = "no deadline" if offered.deadline is None else f"a deadline of {number(offered.deadline)} s"
    return f"{reliability}, {durability}, {deadline}"


def _clash(asked: SubscriberSeen, offered: Publishes) -> Verdict | None:
    """What a subscription asks for in vain, and what to do; None when it asks for no more than is offered."""

    def fail(cause: str, saw: str, try_this: str) -> Verdict:
        return failed(
            cause,
            f"your subscription to {offered.topic} {saw}, so the two never match",
            f"a subscription that requests no more than the publisher offers: {_offer(offered)}",
            "A subscription that requests more than the publisher offers receives no message at all. A warning "
            "(WARN) in your log names the policy.",
            try_this,
        )

    if asked.reliability == "reliable" and offered.qos == "best_effort":
        return fail(
            "hears.reliable",
            "requests reliable, but best effort is offered",
            "Give create_subscription() a QoSProfile with reliability=ReliabilityPolicy.BEST_EFFORT, or "
            "qos_profile_sensor_data. A number as QoS means reliable.",
        )
    if asked.durability == "transient_local" and offered.qos != "latched":
        return fail(
            "hears.transient-local",
            "requests transient local, but volatile is offered",
            "Leave durability out of this subscription's QoSProfile: this publisher keeps no messages for late "
            "joiners.",
        )
    if asked.deadline is not None and offered.deadline is None:
        return fail(
            "hears.deadline-not-offered",
            f"requests a deadline of {number(asked.deadline)} s, but none is offered",
            "Leave the deadline out of the QoSProfile, and let a timer check the clock.",
        )
    if asked.deadline is not None and offered.deadline is not None and asked.deadline < offered.deadline:
        return fail(
            "hears.deadline-too-short",
            f"requests a deadline of {number(asked.deadline)} s, but only {number(offered.deadline)} s is offered",
            f"Request a deadline of {number(offered.deadline)} s or longer.",
        )
    return None


def kept_for_latecomers(recording: Recording, topic: Topic) -> Verdict:
    """Every publisher of `topic` keeps its last message for those who subscribe later: reliable, transient local.

    And a subscription that was made after the watch received a message, if any had been published.
    """
    published = publishes(recording, topic)
    if not published.ok:
        return published
    expected = f"{topic.name} offered as reliable and transient local"
    for publisher in recording.topic(topic.name).publishers:
        if publisher.durability != "transient_local":
            return failed(
                "kept-for-latecomers.volatile",
                f"{topic.name} is offered as {publisher.durability.replace('_', ' ')}",
                expected,
                "A volatile publisher keeps no messages. A late subscription receives nothing until the next "
                "message.",
                "Give create_publisher() QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL).",
            )
        if publisher.reliability != "reliable":
            return failed(
                "kept-for-latecomers.best-effort",
                f"{topic.name} is offered as transient local, but best effort",
                expected,
                "Earlier messages are delivered only to reliable connections. Best effort sends each message once.",
                "Leave reliability out of the QoSProfile, or set ReliabilityPolicy.RELIABLE.",
            )
    return _kept_in_fact(recording, topic, expected) or passed(f"{topic.name} is kept for late joiners")


def _kept_in_fact(recording: Recording, topic: Topic, expected: str) -> Verdict | None:
    """Why messages that are offered as kept do not reach those who come later; None if they do, as far as is known."""
    for publisher in recording.topic(topic.name).publishers:
        if publisher.lifespan is not None and publisher.lifespan < LONG_ENOUGH_S:
            return failed(
                "kept-for-latecomers.lifespan",
                f"{topic.name} is offered as transient local, but with a lifespan of {number(publisher.lifespan)} s",
                expected,
                "A message is discarded when its lifespan is over. A subscription that is created after that "
                "receives nothing.",
                "Leave lifespan out of the QoSProfile of this publisher.",
            )
    if recording.topic(topic.name).kept == 0:
        return failed(
            "kept-for-latecomers.not-delivered",
            f"{topic.name} is offered as reliable and transient local, but a late subscription received nothing",
            expected,
            "A publisher keeps its messages only as long as it exists. Yours was destroyed, or created again after "
            "its last message.",
            "Create the publisher once, in __init__, and keep it.",
        )
    return None
