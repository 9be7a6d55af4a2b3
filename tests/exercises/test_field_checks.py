"""If a value arrives garbled, the program runs again with field checks, and the feedback quotes their error."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from std_msgs.msg import Float32, String

from tests.criteria.by_hand import ended_by_itself, on_topic, recorded
from workbook.criteria import one_of, really_arrives, topic
from workbook.criteria.vocabulary.field_checks import field_check_note
from workbook.exercise.answers import Answer
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.exercise.judging import Judge
from workbook.recording.recording import ProcessRecord, Recording
from workbook.watching.observer import Observer

ROOT = Path(__file__).resolve().parents[2]
BATTERY = topic("/robot/battery", Float32, hz=0.5)
STATUS = topic("/robot/status", String, hz=1.0)
COMPLAINT = "AssertionError: The 'data' field must be of type 'float'"
CHECKED_LOG = f"""\
[INFO] [humanoid]: started
Traceback (most recent call last):
  File "/somewhere/answer.py", line 7, in report
    message.data = 99
  File "/somewhere/std_msgs/msg/_float32.py", line 123, in data
    assert \\
{COMPLAINT}
"""


def battery(*levels: float) -> Recording:
    return recorded(
        on_topic("/robot/battery", times=[2.0 * n for n in range(1, len(levels) + 1)], values=levels)
    )


@pytest.mark.parametrize("levels", [(99.5, 99.0, 98.7), (0.4, 0.0, 0.0), (1e-9, 1e-10)])
def test_numbers_that_arrive(levels: tuple[float, ...]) -> None:
    verdict = really_arrives(battery(*levels), BATTERY)
    assert verdict.ok
    assert not verdict.recheck_fields


@pytest.mark.parametrize(
    ("levels", "saw"),
    [
        ((0.0, 0.0, 0.0), "in all 3 messages"),
        ((0.0, 99.0, 98.0), "in message 1, and 99 after it"),
        ((99.0, 0.0, 98.0), "in message 2, and 98 after it"),
        ((0.0,), "in the only message"),
    ],
)
def test_zeros_where_another_number_was_meant(levels: tuple[float, ...], saw: str) -> None:
    verdict = really_arrives(battery(*levels), BATTERY)
    assert verdict.status == "failed"
    assert verdict.recheck_fields
    assert saw in verdict.saw
    assert "this course's ROS build sends 0.0" in verdict.because


def test_silence_asks_for_no_recheck() -> None:
    verdict = really_arrives(recorded(on_topic("/robot/battery")), BATTERY)
    assert verdict.status == "failed"
    assert not verdict.recheck_fields


def test_the_note_quotes_line_and_complaint() -> None:
    note = field_check_note(ended_by_itself(log=CHECKED_LOG))
    assert f"line 7: {COMPLAINT}" in note
    verdict = really_arrives(replace(battery(0.0), notes=(note,)), BATTERY)
    assert f"line 7: {COMPLAINT}" in verdict.because


@pytest.mark.parametrize("log", ["", CHECKED_LOG.replace(COMPLAINT, "RuntimeError: the sensor is gone")])
def test_checks_that_find_nothing_change_the_reason(log: str) -> None:
    note = field_check_note(ProcessRecord(program="answer.py", log=log))
    verdict = really_arrives(replace(battery(0.0), notes=(note,)), BATTERY)
    assert "The program itself sends 0.0" in verdict.because
    assert "ROS build sends 0.0" not in verdict.because


def test_an_empty_text_is_rechecked_and_a_wrong_word_is_not() -> None:
    empty = recorded(on_topic("/robot/status", "std_msgs/msg/String", [1.0], [""]))
    other = recorded(on_topic("/robot/status", "std_msgs/msg/String", [1.0], ["fine"]))
    assert one_of(empty, STATUS, {"operational"}).recheck_fields
    assert not one_of(other, STATUS, {"operational"}).recheck_fields


@pytest.fixture(scope="module")
def exercise() -> Exercise:
    return load_exercise("08_humanoid_status_publisher", ROOT)


@pytest.fixture(scope="module")
def observer() -> Iterator[Observer]:
    with Observer() as one:
        yield one


def judged(exercise: Exercise, observer: Observer, value: str) -> Judgement:
    text = exercise.source.solution_code
    whole = "Float32(data=self.battery_level)"
    assert text.count(whole) == 1
    return Judge(observer).judge(exercise, Answer(text.replace(whole, f"Float32(data={value})")))


def because(judgement: Judgement) -> str:
    return next(result.because for result in judgement.criteria if result.id == "battery_arrives")


def test_an_int_is_run_again_and_quoted(exercise: Exercise, observer: Observer) -> None:
    judgement = judged(exercise, observer, "int(self.battery_level)")
    recording = judgement.recording
    assert recording is not None
    assert len(recording.notes) == 1
    assert COMPLAINT in because(judgement)
    # The rest comes from the first run: without field checks, and with the end that the judge requested.
    assert recording.process.ended_by == "judge"
    assert COMPLAINT not in recording.process.log
    stored = Recording.from_json(recording.to_json())
    assert judge_recording(exercise, "", stored).criteria == judgement.criteria


def test_a_zero_of_its_own_is_told_apart(exercise: Exercise, observer: Observer) -> None:
    assert "The program itself sends 0.0" in because(judged(exercise, observer, "0.0"))


def test_what_arrives_well_is_not_run_again(exercise: Exercise, observer: Observer) -> None:
    judgement = judged(exercise, observer, "float(self.battery_level)")
    assert judgement.recording is not None
    assert judgement.recording.notes == ()
    assert judgement.full_marks
