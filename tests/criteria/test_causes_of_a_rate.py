"""Why a topic's rate is wrong, on recordings made by hand: a cause is named only if the recording proves it."""

from dataclasses import replace

import pytest
from std_msgs.msg import Float32, String

import workbook.criteria as see
from tests.criteria.by_hand import every, on_topic, recorded
from tests.criteria.test_vocabulary import accepts, refuses
from workbook.criteria import Topic, topic
from workbook.recording.recording import Recording

BATTERY = topic("/robot/battery", Float32, hz=0.5)
STATUS = topic("/robot/status", String, hz=1.0)


def with_times(times: list[float], *, in_lockstep: bool = False, of: Topic = STATUS) -> Recording:
    one = on_topic(of.name, of.type, times, window=(0.0, 14.0))
    return replace(recorded(one, clock="simulated"), in_lockstep=in_lockstep)


def test_in_lockstep_an_even_topic_is_not_held_up() -> None:
    seen = see.rate(with_times(every(2.0, 7), in_lockstep=True), STATUS)
    assert seen.cause == "rate.evenly-too-slow"
    refuses(seen, "nothing delays the timer", about_time=True)


def test_elsewhere_a_slow_callback_makes_an_even_topic_as_well() -> None:
    assert see.rate(with_times(every(2.0, 7)), STATUS).cause == "rate.too-slow"


def test_an_uneven_topic_may_be_held_up_in_lockstep_too() -> None:
    times = [2.0, 3.0, 5.0, 6.0, 8.0, 9.0, 11.0, 12.0, 13.9]
    assert see.rate(with_times(times, in_lockstep=True), STATUS).cause != "rate.evenly-too-slow"


@pytest.mark.parametrize(
    ("times", "words"),
    [
        ([*every(1.0, 6), *every(2.0, 4, 8.0)], "every 1 s until 6.0 s, then one every 2 s"),
        ([*every(1.0, 4), *every(2.0, 4, 7.0)], "every 1 s until 4.0 s, then one every 2 s"),
        ([*every(1.0, 6), *every(0.5, 16, 6.5)], "every 1 s until 6.0 s, then one every 0.5 s"),
    ],
    ids=["more rarely", "more rarely, after a longer moment", "more often"],
)
def test_a_pace_that_changes_is_told_with_both_paces(times: list[float], words: str) -> None:
    for judge in (see.rate, see.counts):
        seen = judge(with_times(times), STATUS)
        assert seen.cause == "rate.changes"
        refuses(seen, words, "condition", about_time=True)


@pytest.mark.parametrize(
    "times",
    [
        [*every(1.0, 6), *every(1.0, 5, 9.0)],
        [1.0, 2.0, 3.0, 4.0, 6.0, 8.0],
        [1.0, 2.0, 3.0, 4.0, 6.0, 7.0, 9.0, 11.0, 12.0, 14.0],
    ],
    ids=["one silence", "too few to tell", "to and fro"],
)
def test_no_other_topic_is_said_to_change_its_pace(times: list[float]) -> None:
    seen = see.rate(with_times(times), STATUS)
    assert not seen.ok and seen.cause != "rate.changes"


def test_of_too_few_messages_a_late_first_one_is_told() -> None:
    few = on_topic(BATTERY.name, BATTERY.type, [2.7, 4.7, 6.7], window=(0.0, 8.5))
    seen = see.rate(recorded(few), BATTERY)
    assert seen.cause == "rate.first-late"
    refuses(seen, "the first arrived after 2.7 s", "before it publishes", about_time=True)


def silent_beside(other_node: str) -> Recording:
    """Record no charges and twelve words, which come from this node or from another one."""
    battery = on_topic(BATTERY.name, BATTERY.type)
    status = on_topic(STATUS.name, STATUS.type, every(1.0, 12), ["operational"] * 12, node=other_node)
    return replace(recorded(battery, status), wanted=(BATTERY.name, STATUS.name))


def test_a_silent_topic_of_a_node_that_works() -> None:
    seen = see.rate(silent_beside("/humanoid"), BATTERY)
    assert seen.cause == "no-message.silent-beside-others"
    refuses(
        seen,
        "while messages kept arriving on /robot/status",
        "another topic's publisher",
        "create_timer(2.0",
        about_time=True,
    )
    assert "spins" not in seen.because


def test_a_topic_without_a_rate_is_told_of_no_timer() -> None:
    quiet = topic(BATTERY.name, Float32)
    refuses(
        see.no_message(silent_beside("/humanoid"), quiet) or see.passed(""),
        "Call a function",
        about_time=True,
    )


def test_of_another_node_nothing_is_known() -> None:
    assert see.rate(silent_beside("/other"), BATTERY).cause == "no-message.silent"


def test_an_even_topic_at_the_right_rate_passes() -> None:
    accepts(see.rate(with_times(every(1.0, 13), in_lockstep=True), STATUS), "1 Hz")
