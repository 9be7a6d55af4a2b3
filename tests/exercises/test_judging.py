"""Judge stored recordings: the verdicts are the same every time, in every process."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from workbook.criteria import Recording as RecordingSeen
from workbook.criteria import Verdict, criterion
from workbook.exercise.definition import BrokenCriteria, load_exercise
from workbook.exercise.judgement import Judgement, judge_recording, judgement_as_provisional
from workbook.exercise.serialization import judgement_from_json, judgement_to_json
from workbook.exercise.source import UnknownExercise
from workbook.recording.recording import (
    Arrival,
    NodeSeen,
    ProcessRecord,
    PublisherSeen,
    Recording,
    TopicRecording,
)
from workbook.recording.script import Publishes

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


def calls_of_publish_level(delay: float) -> Recording:
    """Record a right answer of exercise 03. Every number arrives `delay` seconds after it was published."""
    exercise = load_exercise("03_publishers_and_messages", ROOT)
    number_in = exercise.criteria[-1].judge.__globals__["number_in"]
    [part] = exercise.plan.script.parts
    assert isinstance(part, Publishes)
    [line] = part.lines
    levels, now = [], 1.0
    said = [Arrival(now, now, {"data": "made"}, now)]
    for number, value in enumerate(line.value["data"].splitlines(), start=1):
        now += 0.06
        meant = number_in(value)
        how = "raised ValueError" if meant is None else "returned"
        for text, moment in (
            (f"call {number}: publish_level({value})", now),
            (f"call {number} {how}", now + 0.02),
        ):
            said.append(Arrival(moment, moment, {"data": text}, moment))
        if meant is not None:
            sent = now + 0.01
            levels.append(Arrival(sent + delay, sent + delay, {"data": meant}, sent))
    said.append(Arrival(now + 1.0, now + 1.0, {"data": "done"}, now + 1.0))

    def topic(name: str, kind: str, arrivals: list[Arrival]) -> TopicRecording:
        seen = PublisherSeen("/battery_publisher", f"std_msgs/msg/{kind}", "reliable", "volatile", 0.0)
        return TopicRecording(name, (seen,), (), tuple(arrivals), (0.0, 4.5))

    return Recording(
        clock="wall",
        domain_id=17,
        watched_s=4.5,
        wall_s=5.0,
        topics={
            "/driver/report": topic("/driver/report", "String", said),
            "/robot/battery": topic("/robot/battery", "Float32", levels),
        },
        nodes=(NodeSeen("/battery_publisher", 0.1),),
        process=ProcessRecord(program="answer.py", exit=0, ended_at=5.0, ended_by="judge", watched_for=5.0),
    )


@pytest.mark.parametrize("delay", [0.0, 0.2])
def test_a_number_that_arrives_late_belongs_to_the_call_that_published_it(delay: float) -> None:
    recording = calls_of_publish_level(delay)
    judgement = judge_recording(load_exercise("03_publishers_and_messages", ROOT), "0" * 64, recording)
    assert judgement.full_marks, [result for result in judgement.criteria if result.status != "passed"]
