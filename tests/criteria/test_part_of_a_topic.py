"""One of several publishers on a topic, and errors at the end, on recordings made by hand."""

from dataclasses import replace

from std_msgs.msg import String

import workbook.criteria as see
from tests.criteria.by_hand import LIVING, ended_by_itself, on_topic, recorded
from workbook.criteria import topic

REPORTS = topic("/robot/faults", String)
TWO_TALK = recorded(
    on_topic(
        REPORTS.name,
        "std_msgs/msg/String",
        [1.0, 2.0, 5.0, 6.0],
        ["a: none", "a: none", "b: none", "a: none"],
    )
)


def test_the_messages_of_one_are_watched_from_the_first_of_them_on() -> None:
    own = see.part_of(TWO_TALK, REPORTS, lambda text: text.startswith("b"))
    assert see.values(own, REPORTS) == ["b: none"]
    assert own.topic(REPORTS.name).window == (5.0, 14.0)


def test_who_says_nothing_has_no_part() -> None:
    own = see.part_of(TWO_TALK, REPORTS, lambda text: text.startswith("c"))
    assert see.values(own, REPORTS) == []
    assert own.topic(REPORTS.name).window == TWO_TALK.topic(REPORTS.name).window


LOG = 'Traceback (most recent call last):\n  File "/answers/answer.py", line 7, in go\nNameError: name x\n'


def test_only_an_error_that_ended_the_program_is_blamed() -> None:
    assert see.ended_by_error(recorded(process=replace(LIVING, log=LOG)), "silence", "none") is None
    verdict = see.ended_by_error(recorded(process=ended_by_itself(LOG)), "silence", "none")
    assert verdict is not None
    assert verdict.saw.startswith("silence; the program ended with an error in line 7: NameError")


def test_an_error_after_ctrl_c_is_blamed() -> None:
    assert see.failed_at_the_end(recorded(process=replace(LIVING, log=LOG)), "silence", "none") is None
    verdict = see.failed_at_the_end(recorded(process=replace(LIVING, end_log=LOG)), "silence", "none")
    assert verdict is not None
    assert verdict.saw == "silence; error after Ctrl-C in line 7: NameError: name x"
