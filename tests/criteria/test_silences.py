"""Why a topic went silent, on recordings made by hand."""

from dataclasses import replace

from std_msgs.msg import Float32, String

import workbook.criteria as see
from tests.criteria.by_hand import LIVING, ended_by_itself, every, on_topic, recorded
from tests.criteria.test_vocabulary import TRACEBACK, refuses
from workbook.criteria import topic
from workbook.recording.recording import ProcessRecord, Recording

BATTERY = topic("/robot/battery", Float32, hz=0.5)
STATUS = topic("/robot/status", String, hz=1.0)


def stopped(words: int, process: ProcessRecord = LIVING) -> Recording:
    """Record three charges in 14 s, and `words` words, one per second."""
    recording = recorded(
        on_topic(BATTERY.name, BATTERY.type, every(2.0, 3)),
        on_topic(STATUS.name, STATUS.type, every(1.0, words), ["operational"] * words),
        process=process,
    )
    return replace(recording, wanted=(BATTERY.name, STATUS.name))


def test_a_topic_that_stops_while_another_goes_on() -> None:
    refuses(see.rate(stopped(13), BATTERY), "while messages kept arriving on /robot/status", about_time=True)


def test_once_it_has_followed_simulated_time_that_is_final() -> None:
    verdict = see.rate(replace(stopped(13), following={BATTERY.name: True}), BATTERY)
    assert verdict.cause == "silence.of-one" and not verdict.about_time and verdict.pace_of == BATTERY.name


def test_everything_stops_at_once() -> None:
    refuses(
        see.rate(stopped(7), BATTERY),
        "the last message on /robot/status arrived at 7.0 s",
        "never returns",
        about_time=True,
    )


def test_a_program_that_crashed_is_told_its_error() -> None:
    refuses(see.rate(stopped(7, ended_by_itself(TRACEBACK)), BATTERY), "line 7", "NameError", about_time=True)


def test_a_program_that_ended_is_told_so() -> None:
    refuses(
        see.rate(stopped(7, ended_by_itself("", 0)), BATTERY),
        "then the program ended",
        "rclpy.spin",
        about_time=True,
    )
