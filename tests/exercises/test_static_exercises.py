"""Exercises of `kind: static`: the type checker reads the answer before the criteria judge the recording."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from workbook.criteria import Reason, criterion, mypy_clean, mypy_objects, probe
from workbook.exercise import judging
from workbook.exercise.answers import Answer
from workbook.exercise.definition import BrokenCriteria, Exercise, load_exercise
from workbook.exercise.judgement import judge_recording
from workbook.exercise.judging import Judge
from workbook.exercise.serialization import judgement_from_json, judgement_to_json
from workbook.recording.recording import Finding, Recording
from workbook.typechecking.typecheck import TypeCheckFailed
from workbook.watching.observer import Observer

ROOT = Path(__file__).resolve().parents[2]
MISUSE = probe("a text for a level", 'from answer import drain\ndrain("full")  # wrong\n')
ANSWER = """\
import rclpy
from rclpy.node import Node
from std_msgs.msg import Float32


def drain(level{hint}):
    return level - 0.5


class Robot(Node):
    def __init__(self) -> None:
        super().__init__("robot")
        self.level = self.create_publisher(Float32, "/robot/battery", 10)
        self.create_timer(2.0, self.send)

    def send(self) -> None:
        self.level.publish(Float32(data=99.5))


if __name__ == "__main__":
    rclpy.init()
    rclpy.spin(Robot())
"""
TYPED = ANSWER.replace("(level{hint})", "(level: float) -> float")
UNTYPED = ANSWER.replace("{hint}", "")


@criterion(points=1, title="Clean")
def clean(recording):  # type: ignore[no-untyped-def]
    return mypy_clean(recording)


@criterion(points=1, title="Guarded")
def guarded(recording):  # type: ignore[no-untyped-def]
    return mypy_objects(
        recording, MISUSE, Reason("guarded.no-hint", {"because": "No hint.", "try": "Add one."})
    )


def exercise(kind: str) -> Exercise:
    """Return exercise 05, shortened, as an exercise of another kind."""
    real = load_exercise("05_timers", ROOT)
    short = replace(
        real,
        criteria=(clean, guarded),
        plan=replace(real.plan, topics=("/robot/battery",), simulated_seconds=4.0),
        periods={},
        probes={MISUSE.name: MISUSE.code},
    )
    short.__dict__["source"] = replace(real.source, kind=kind)
    return short


@pytest.mark.parametrize(("answer", "passed"), [(TYPED, (True, True)), (UNTYPED, (False, False))])
def test_an_answer_is_read_and_run(answer: str, passed: tuple[bool, bool]) -> None:
    with Observer() as observer:
        judgement = Judge(observer).judge(exercise("static"), Answer(answer))
    assert tuple(result.status == "passed" for result in judgement.criteria) == passed
    assert judgement.recording is not None and judgement.recording.findings is not None
    assert judgement.recording.topic("/robot/battery").arrivals
    stored = json.dumps(judgement_to_json(judgement), allow_nan=False)
    again = judgement_from_json(json.loads(stored))
    assert again == judgement
    assert again.recording is not None
    assert judge_recording(exercise("static"), "", again.recording).criteria == judgement.criteria


def test_other_kinds_are_not_read(monkeypatch: pytest.MonkeyPatch) -> None:
    def never(*_: object) -> tuple[Finding, ...]:
        raise AssertionError("mypy was asked")

    monkeypatch.setattr(judging, "type_check", never)
    with Observer() as observer:
        judgement = Judge(observer).judge(
            replace(exercise("program"), criteria=load_exercise("05_timers", ROOT).criteria), Answer(TYPED)
        )
    assert judgement.recording is not None
    assert judgement.recording.findings is None


def test_a_failing_type_checker_is_no_students_zero(monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(*_: object) -> tuple[Finding, ...]:
        raise TypeCheckFailed("mypy is not installed")

    monkeypatch.setattr(judging, "type_check", fails)
    with Observer() as observer:
        judgement = Judge(observer).judge(exercise("static"), Answer(TYPED))
    assert (judgement.status, judgement.reason, judgement.score) == (
        "infra_error",
        "mypy is not installed",
        None,
    )


def test_a_criterion_that_asks_in_another_kind_is_an_error_of_ours() -> None:
    judgement = judge_recording(exercise("program"), "", Recording("wall", 1))
    assert judgement.status == "infra_error"
    assert judgement.reason is not None and "kind: static" in judgement.reason


def test_two_probes_of_one_name_are_refused(tmp_path: Path) -> None:
    for folder in ("solutions", "exercises/criteria"):
        (tmp_path / folder).mkdir(parents=True)
        name = f"{folder}/05_timers.py"
        (tmp_path / name).write_bytes((ROOT / name).read_bytes())
    with (tmp_path / "exercises/criteria/05_timers.py").open("a") as file:
        file.write('\nONE = see.probe("use", "x = 1")\nTWO = see.probe("use", "x = 2")\n')
    with pytest.raises(BrokenCriteria, match="same name"):
        load_exercise("05_timers", tmp_path)
