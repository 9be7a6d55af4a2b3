"""A topic's recording is limited in bytes and messages, and says what it left out."""

import hashlib

import pytest
from rclpy.serialization import serialize_message
from std_msgs.msg import Float32MultiArray, UInt8MultiArray

from tests.programs.support import write
from workbook.programs.spec import ProgramSpec
from workbook.recording.plan import Plan
from workbook.recording.recording import Recording, TopicRecording
from workbook.recording.script import Script, publish
from workbook.watching.message_quota import MessageQuota
from workbook.watching.observer import Observer
from workbook.watching.watch import Watch
from workbook.watching.watched_topic import MOST_NOTED, WatchedTopic, finished

END_S = 10_000.0
ANGLES = serialize_message(Float32MultiArray(data=[0.5] * 12))
PICTURE = serialize_message(UInt8MultiArray(data=bytes(900_000)))
TOO_LARGE = bytes(4_000_001)


def watched(room: MessageQuota, kind: str = "Float32MultiArray") -> WatchedTopic:
    topic = WatchedTopic("/joints", room)
    topic.subscribed_type = f"std_msgs/msg/{kind}"
    topic.matched_at = 0.0
    return topic


def keep(topic: WatchedTopic, *messages: bytes) -> TopicRecording:
    """Record a topic with these messages, one per second."""
    for moment, raw in enumerate(messages, start=1):
        topic.keep(float(moment), float(moment), float(moment), raw)
    return finished(topic, END_S)


def test_room_is_used_up_for_good() -> None:
    room = MessageQuota(100, 3)
    assert [room.take(40), room.take(70), room.take(1)] == [True, False, False]
    assert room.is_short_of_bytes
    room.clear()
    assert [room.take(1) for _ in range(4)] == [True, True, True, False]
    assert not room.is_short_of_bytes


def test_what_does_not_fit_is_told_with_its_moment() -> None:
    seen = keep(watched(MessageQuota(2 * len(ANGLES), 10)), ANGLES, ANGLES, ANGLES, ANGLES)
    assert [one.t for one in seen.arrivals] == [1.0, 2.0]
    assert (seen.not_kept, seen.full_at, seen.room) == (2, 3.0, 2 * len(ANGLES))
    seen = keep(watched(MessageQuota(1000, 3)), *[ANGLES] * 5)
    assert len(seen.arrivals) == 3
    assert (seen.not_kept, seen.full_at, seen.room) == (2, 4.0, None)


def test_broken_messages_are_told_with_the_moment_of_the_first() -> None:
    seen = keep(watched(MessageQuota(10_000, 10)), ANGLES, b"\x00", TOO_LARGE, ANGLES, TOO_LARGE)
    assert [one.t for one in seen.arrivals] == [1.0, 4.0]
    assert (seen.undecodable, seen.too_large, seen.not_kept) == (1, 2, 2)
    assert (seen.broken_at, seen.full_at) == (2.0, None)
    assert (
        Recording.from_json(Recording(clock="wall", domain_id=1, topics={"/joints": seen}).to_json()).topic(
            "/joints"
        )
        == seen
    )


def test_what_comes_after_the_end_is_not_told() -> None:
    topic = watched(MessageQuota(10_000, 2))
    keep(topic, ANGLES, ANGLES, b"\x00" * 20_000, TOO_LARGE)
    seen = finished(topic, 2.0)
    assert (len(seen.arrivals), seen.undecodable, seen.not_kept, seen.broken_at, seen.full_at) == (
        2,
        0,
        0,
        None,
        None,
    )


def test_a_large_message_takes_hardly_more_room_than_what_is_kept_of_it() -> None:
    """A camera may send 27 MB a second. The quota of 4 MB still holds more than seven seconds of it."""
    seen = keep(watched(MessageQuota(4_000_000, 10_000), "UInt8MultiArray"), *[PICTURE] * 250)
    assert len(seen.arrivals) > 200
    assert seen.full_at == len(seen.arrivals) + 1
    picture = seen.arrivals[-1].value["data"]
    assert (picture["length"], picture["sha256"]) == (900_000, hashlib.sha256(bytes(900_000)).hexdigest())


def test_a_large_message_that_is_none_is_told() -> None:
    seen = keep(watched(MessageQuota(4_000_000, 10)), b"\xff" * 20_000, ANGLES)
    assert (len(seen.arrivals), seen.undecodable, seen.broken_at) == (1, 1, 1.0)


def test_not_even_the_moments_of_what_is_not_kept_take_memory_without_end() -> None:
    topic = watched(MessageQuota(0, 0))
    assert keep(topic, *[ANGLES] * (MOST_NOTED + 5)).not_kept == MOST_NOTED
    topic.forget()
    assert finished(topic, END_S).not_kept == 0


PROGRAM = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32MultiArray

rclpy.init()
node = Node("humanoid")
publishers = {
    name: node.create_publisher(Float32MultiArray, name, 100)
    for name in ("/judged", "/heard", "/one", "/another")
}
ticks = 0
def tick():
    global ticks
    ticks += 1
    for name, publisher in publishers.items():
        if name != "/heard" or ticks <= 4:
            publisher.publish(Float32MultiArray(data=[0.5] * 1000))
node.create_timer(0.1, tick)
rclpy.spin(node)
"""


@pytest.fixture(scope="module")
def recording(tmp_path_factory: pytest.TempPathFactory) -> Recording:
    program = write(tmp_path_factory.mktemp("program"), PROGRAM)
    lines = [(0.1 * number, {"data": [0.25] * 3000}) for number in range(1, 6)]
    script = Script((publish("/heard", Float32MultiArray, lines, awaited=False),))
    plan = Plan(("/judged", "/heard"), 0.1, 0.1, wall_seconds=4.0, script=script, bytes_per_topic=20_000)
    with Observer() as observer, Watch(observer, ProgramSpec(program), plan, "wall") as watch:
        return watch.observe()


def test_each_judged_topic_has_room_of_its_own_and_the_others_share_theirs(recording: Recording) -> None:
    judged = recording.topic("/judged")
    assert len(judged.arrivals) == 4
    assert judged.full_at is not None and judged.room == 20_000
    others = [recording.topic(name) for name in ("/one", "/another")]
    assert sum(len(topic.arrivals) for topic in others) == 4
    assert all(topic.full_at is not None for topic in others)


def test_what_the_judge_says_itself_is_free(recording: Recording) -> None:
    """The recorder receives it, too, if an answer publishes to the same topic."""
    heard = recording.topic("/heard")
    assert len(recording.published) == 5
    assert len([one for one in heard.arrivals if len(one.value["data"]) == 3000]) == 5
    assert heard.full_at is None
