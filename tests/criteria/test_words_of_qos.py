"""Whether a subscription's requested QoS matches the offered one, and whether late subscribers still get a message."""

from dataclasses import replace

import pytest
from std_msgs.msg import Bool, String

import workbook.criteria as see
from tests.criteria.by_hand import on_topic, publisher, recorded
from workbook.recording.recording import Recording, SubscriberSeen, TopicRecording

BEAT, ALARM = "/robot/heartbeat", "/dashboard/alarm"
STRING, BOOL = "std_msgs/msg/String", "std_msgs/msg/Bool"
ASKED = SubscriberSeen("/dashboard", STRING, "best_effort", "volatile")


def listening(*subscribers: SubscriberSeen) -> Recording:
    return recorded(TopicRecording(BEAT, subscribers=subscribers))


@pytest.mark.parametrize("asked", [ASKED, replace(ASKED, deadline=0.5), replace(ASKED, deadline=2.0)])
def test_a_subscription_may_ask_for_less_than_is_offered(asked: SubscriberSeen) -> None:
    for qos in ("best_effort", "reliable", "latched"):
        assert see.hears(listening(asked), see.publish(BEAT, String, [], qos=qos, deadline=0.5)).ok


@pytest.mark.parametrize(
    ("asked", "words", "step"),
    [
        (
            replace(ASKED, reliability="reliable"),
            "reliable delivery, but the publisher offers only best-effort delivery",
            "BEST_EFFORT",
        ),
        (
            replace(ASKED, durability="transient_local"),
            "transient local durability, but the publisher offers only volatile durability",
            "Leave durability out",
        ),
        (
            replace(ASKED, deadline=0.4),
            "deadline of 0.4 s, but the publisher offers only 0.5 s",
            "0.5 s or longer",
        ),
        (replace(ASKED, type=BOOL), "of type Bool", "Import String"),
    ],
)
def test_asking_for_more_is_told_with_the_policy(asked: SubscriberSeen, words: str, step: str) -> None:
    verdict = see.hears(listening(asked), see.publish(BEAT, String, [], qos="best_effort", deadline=0.5))
    assert not verdict.ok
    assert words in verdict.saw
    assert step in verdict.try_this
    assert verdict.expected and verdict.because


def test_a_deadline_that_nobody_offers_is_told() -> None:
    verdict = see.hears(listening(replace(ASKED, deadline=2.0)), see.publish(BEAT, String, []))
    assert "requests a deadline of 2 s, but the publisher offers none" in verdict.saw
    assert "no deadline" in verdict.expected


def test_one_of_several_subscriptions_that_matches_is_enough() -> None:
    said = see.publish(BEAT, String, [], qos="best_effort")
    assert see.hears(listening(replace(ASKED, reliability="reliable"), ASKED), said).ok


def test_nobody_listens() -> None:
    assert "nothing subscribes" in see.hears(recorded(), see.publish(BEAT, String, [])).saw


@pytest.mark.parametrize(
    ("reliability", "durability", "words"),
    [
        ("reliable", "transient_local", ""),
        ("reliable", "volatile", "is offered as volatile"),
        ("best_effort", "transient_local", "but as best effort"),
    ],
)
def test_a_message_is_kept_by_a_reliable_transient_local_publisher(
    reliability: str, durability: str, words: str
) -> None:
    offers = replace(publisher(BOOL), reliability=reliability, durability=durability)
    topic = replace(on_topic(ALARM, BOOL), publishers=(offers,))
    verdict = see.kept_for_latecomers(recorded(topic), see.topic(ALARM, Bool))
    assert verdict.ok is (words == "")
    assert words in verdict.saw
    assert verdict.ok or (verdict.because and verdict.try_this)


@pytest.mark.parametrize(
    ("lifespan", "kept", "cause"),
    [
        (None, None, ""),
        (None, 1, ""),
        (7200.0, 1, ""),
        (0.3, 1, "kept-for-latecomers.lifespan"),
        (0.3, 0, "kept-for-latecomers.lifespan"),
        (None, 0, "kept-for-latecomers.not-delivered"),
    ],
)
def test_what_is_kept_must_reach_a_late_subscription(
    lifespan: float | None, kept: int | None, cause: str
) -> None:
    offers = replace(publisher(BOOL), durability="transient_local", lifespan=lifespan)
    topic = replace(on_topic(ALARM, BOOL), publishers=(offers,), kept=kept)
    assert see.kept_for_latecomers(recorded(topic), see.topic(ALARM, Bool)).cause == cause


def test_a_topic_of_another_type_is_told_first() -> None:
    topic = on_topic(ALARM, STRING)
    assert "carries String" in see.kept_for_latecomers(recorded(topic), see.topic(ALARM, Bool)).saw
