"""A program's outputs compared with its inputs; stamps; and heartbeats while the program is busy."""

import pytest
from std_msgs.msg import String

from workbook.criteria import Relay, Stamp, Waits, beats, topic
from workbook.recording.recording import Arrival, Recording, TopicRecording


def test_everything_in_order_shows_nothing() -> None:
    relay = Relay("abc", "abc")
    assert not (relay.missing or relay.repeated or relay.strange or relay.misplaced)
    assert not (relay.stops or relay.rest_is_missing)
    assert relay.answered == ["a", "b", "c"]


@pytest.mark.parametrize(
    ("came", "missing", "stops", "rest_is_missing"),
    [
        ("ab", ["c", "d"], True, True),
        ("ba", ["c", "d"], False, True),
        ("aab", ["c", "d"], False, True),
        ("abd", ["c"], False, False),
        ("", ["a", "b", "c", "d"], True, True),
    ],
)
def test_what_is_missing_may_be_the_rest(
    came: str, missing: list[str], stops: bool, rest_is_missing: bool
) -> None:
    relay = Relay("abcd", came)
    assert (relay.missing, relay.stops, relay.rest_is_missing) == (missing, stops, rest_is_missing)


def test_an_item_that_was_sent_twice_may_come_twice() -> None:
    assert Relay("aba", "aba").repeated == []
    assert Relay("aba", "ab").missing == ["a"]
    assert Relay("aba", "abaab").repeated == [("a", 3), ("b", 2)]


def test_what_was_never_sent_is_strange_and_the_first_in_a_wrong_place_is_told() -> None:
    relay = Relay("abc", "axcb")
    assert (relay.strange, relay.misplaced) == (["x"], (2, "x", "b"))


def test_waits_are_late_if_too_many_take_long() -> None:
    waits = Waits([0.1] * 18 + [0.7, 0.9], at_once_s=0.5)
    assert (waits.late, waits.typical_s, waits.first_s, waits.last_s) == ([0.7, 0.9], 0.1, 0.1, 0.8)
    assert waits.are_late(0.95) and not waits.are_late(0.85)


def test_no_wait_is_never_late() -> None:
    waits = Waits([], at_once_s=0.5)
    assert (waits.typical_s, waits.first_s, waits.last_s, waits.are_late(0.9)) == (0.0, 0.0, 0.0, False)


def test_a_stamp_is_read_from_a_header_and_made_for_a_moment() -> None:
    stamp = Stamp.of({"header": {"stamp": {"sec": 47, "nanosec": 650_000_000}}})
    assert stamp == Stamp.at(47.65) == (47, 650_000_000)
    assert stamp.seconds == pytest.approx(47.65)
    assert stamp._asdict() == {"sec": 47, "nanosec": 650_000_000}


def heart(*times: float) -> Recording:
    arrivals = tuple(Arrival(t, t, {"data": "beat"}) for t in times)
    seen = TopicRecording("/robot/heartbeat", arrivals=arrivals, window=(0.0, 2.0))
    return Recording("wall", 1, watched_s=2.0, topics={seen.name: seen})


def test_beats_are_counted_in_all_and_while_the_program_is_busy() -> None:
    found = beats(heart(0.2, 0.4, 0.6, 1.6, 1.8), topic("/robot/heartbeat", String, hz=5.0))
    assert (found.count, found.due, found.share, found.last_s) == (5, 10, 0.5, 1.8)
    assert (found.silence.start, found.silence.end) == (0.6, 1.6)
    busy = [(0.3, 0.7), (0.7, 1.5)]
    assert found.within(busy) == [2, 0]
    assert found.due_within(busy) == pytest.approx(6.0)


def test_a_heart_that_never_beat_has_no_last_beat() -> None:
    found = beats(heart(), topic("/robot/heartbeat", String, hz=5.0))
    assert (found.count, found.last_s, found.typical_s) == (0, 0.0, 0.0)
