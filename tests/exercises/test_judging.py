"""Judging stored recordings: the same verdicts every time, in every process."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from workbook.criteria import Recording as RecordingSeen
from workbook.criteria import Verdict, criterion
from workbook.exercise.definition import BrokenCriteria, load_exercise
from workbook.exercise.exchange import judgement_from_json, judgement_to_json
from workbook.exercise.judging import Judgement, judge_recording, judgement_as_provisional
from workbook.exercise.source import UnknownExercise
from workbook.observing.recording import Recording

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
RECORDINGS = sorted((ROOT / "tests" / "recordings" / STEM).glob("*.json"))
LOST: dict[str, set[str]] = {
    "solution": set(),
    "eleven_values": {"twelve_values"},
    "period_for_frequency": {"joint_rate"},
    "raises_at_once": {"program_runs"},
    "starter": {"joint_topic"},
    "wrong_name": {"joint_topic"},
}


def judged(path: Path, **options: bool) -> Judgement:
    return judge_recording(load_exercise(STEM, ROOT), "0" * 64, Recording.load(path), **options)


@pytest.mark.parametrize("path", RECORDINGS, ids=lambda path: path.stem)
def test_a_stored_recording_loses_what_it_lost_when_it_was_made(path: Path) -> None:
    judgement = judged(path)
    assert judgement.status == "graded"
    lost = {result.id for result in judgement.criteria if result.status in ("failed", "partial")}
    assert lost == LOST[path.stem]
    assert judgement.full_marks is (path.stem == "solution")
    assert judgement.max_score == 10
    assert judgement == judged(path), "criteria are pure functions of the recording"


@pytest.mark.parametrize("path", RECORDINGS, ids=lambda path: path.stem)
@pytest.mark.parametrize("provisional", [True, False])
def test_a_judgement_survives_the_way_between_processes(path: Path, provisional: bool) -> None:
    judgement = judged(path, real_life=True)
    if provisional:
        judgement = judgement_as_provisional(judgement)
        assert judgement.provisional
    line = json.dumps(judgement_to_json(judgement), allow_nan=False)
    assert judgement_from_json(json.loads(line)) == judgement


def test_a_judgement_without_recording_survives_as_well() -> None:
    ours = Judgement(STEM, "0" * 64, "infra_error", "the slot ended with code 1", (), None)
    assert judgement_from_json(json.loads(json.dumps(judgement_to_json(ours)))) == ours
    assert ours.score is None
    assert not ours.full_marks


def test_a_criterion_that_crashes_gives_no_score_at_all() -> None:
    @criterion(points=1, title="Crashes")
    def crashes(recording: RecordingSeen) -> Verdict:
        raise KeyError("battery")

    exercise = load_exercise(STEM, ROOT)
    broken = replace(exercise, criteria=(*exercise.criteria, crashes))
    judgement = judge_recording(broken, "0" * 64, Recording.load(RECORDINGS[0]))
    assert judgement.status == "infra_error"
    assert judgement.score is None
    assert judgement.reason is not None
    assert "crashes" in judgement.reason
    assert judgement.recording is not None


def test_an_exercise_is_found_by_stem_and_by_slug() -> None:
    assert load_exercise("joint_positions", ROOT).stem == STEM
    with pytest.raises(UnknownExercise, match="09_joint_positions"):
        load_exercise("joint_position", ROOT)


@pytest.mark.parametrize(
    ("criteria", "words"),
    [
        (None, "has no criteria"),
        ("x = 1\n", "defines no criterion"),
        ("import rclpie\n", "rclpie"),
        ("x = = 1", "Syntax"),
    ],
)
def test_broken_criteria_are_named(criteria: str | None, words: str, tmp_path: Path) -> None:
    (tmp_path / "solutions").mkdir()
    (tmp_path / "exercises" / "criteria").mkdir(parents=True)
    (tmp_path / "solutions" / f"{STEM}.py").write_bytes((ROOT / "solutions" / f"{STEM}.py").read_bytes())
    if criteria is not None:
        (tmp_path / "exercises" / "criteria" / f"{STEM}.py").write_text(criteria)
    with pytest.raises(BrokenCriteria, match=words):
        load_exercise(STEM, tmp_path)
