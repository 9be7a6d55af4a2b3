"""Stored recordings can be judged again without rclpy: on any laptop, years later."""

import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from workbook.exercise.definition import OWN_CRITERIA, load_exercise
from workbook.exercise.judgement import KEPT, judge_recording
from workbook.exercise.source import stems
from workbook.grading.new_results import GradedBy, Submission, graded_result
from workbook.grading.regrade import regrade
from workbook.grading.results_file import RESULTS, ResultsFile, last_results
from workbook.recording.recording import Published, Recording

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"

WITHOUT_RCLPY = """
import sys

class Blocker:
    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] == "rclpy":
            raise ImportError(f"there is no rclpy here: {name}")

sys.meta_path.insert(0, Blocker())
"""
REGRADE = """
from workbook.cli.main import main
code = main(sys.argv[1:])
assert not [name for name in sys.modules if name.split(".")[0] == "rclpy"]
sys.exit(code)
"""
LOAD_ALL = """
from workbook.exercise.definition import load_exercise
for stem in sys.argv[1:]:
    assert load_exercise(stem).criteria
print("loaded")
"""
STRICTER = """
import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion


@criterion(points=2, title="The joints were seen by the instructor")
def seen_by_me(recording: Recording) -> Verdict:
    return see.passed("seen")
"""


def without_rclpy(code: str, *arguments: object) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", WITHOUT_RCLPY + code, *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_rclpy_is_really_out_of_reach() -> None:
    found = without_rclpy("import rclpy")
    assert found.returncode != 0
    assert "there is no rclpy here: rclpy" in found.stderr


def test_regrading_needs_no_rclpy(tmp_path: Path) -> None:
    out = tmp_path / "out"
    exercise = load_exercise(STEM, ROOT)
    with ResultsFile(out / RESULTS) as file:
        for name in ("solution", "eleven_values", "raises_at_once"):
            stored = Recording.load(ROOT / "tests" / "recordings" / STEM / f"{name}.json")
            judgement = judge_recording(exercise, "a" * 64, stored)
            submission = Submission(name, f"{name}.py", "a" * 64)
            file.append(graded_result(submission, [judgement], GradedBy(exercise, "sandbox", out)))
    own = tmp_path / "own"
    own.mkdir()
    (own / f"{STEM}.py").write_text(STRICTER)
    command = ["grade", "--regrade", "--exercise", STEM, "--criteria", own, "--out", out]
    found = without_rclpy(REGRADE, *command, "--format", "html,canvas,moodle,nbgrader,gradescope")
    assert found.returncode == 0, found.stderr
    assert "3 recordings of 09_joint_positions judged again; the marks of 3 changed." in found.stdout
    assert "eleven_values: 9 → 11" in found.stdout
    scores = [json.loads(line)["score"] for line in (out / RESULTS).read_text().splitlines()]
    assert sorted(scores[3:]) == sorted(score + 2 for score in scores[:3])
    assert len(list((out / "pages").glob("*.html"))) == 4


CRASHES = STRICTER.replace('see.passed("seen")', "see.passed(str(1 // 0))")


def grade_stored(out: Path, criteria: str, own: Path, *, keep: bool = True) -> list[str]:
    """Grade two stored recordings by custom criteria. Return the command that judges them again."""
    own.mkdir()
    (own / f"{STEM}.py").write_text(criteria)
    with pytest.MonkeyPatch.context() as patch, ResultsFile(out / RESULTS) as file:
        patch.setenv(OWN_CRITERIA, str(own))
        exercise = load_exercise(STEM, ROOT)
        for name in ("solution", "eleven_values"):
            stored = Recording.load(ROOT / "tests" / "recordings" / STEM / f"{name}.json")
            judgement = judge_recording(exercise, "a" * 64, stored)
            if not keep:
                judgement = replace(judgement, recording=None)
            submission = Submission(name, f"{name}.py", "a" * 64)
            file.append(graded_result(submission, [judgement], GradedBy(exercise, "sandbox", out)))
    return ["grade", "--regrade", "--exercise", STEM, "--criteria", str(own), "--out", str(out)]


def test_an_answer_whose_criterion_crashed_is_judged_again(tmp_path: Path) -> None:
    own = tmp_path / "own"
    command = grade_stored(tmp_path / "out", CRASHES, own)
    found = without_rclpy(REGRADE, *command)
    assert found.returncode == 1, found.stdout + found.stderr
    assert "solution: not judged again" in found.stdout
    (own / f"{STEM}.py").write_text(STRICTER)
    found = without_rclpy(REGRADE, *command)
    assert found.returncode == 0, found.stdout + found.stderr
    assert "the marks of 2 changed" in found.stdout
    assert "solution: no score → 12" in found.stdout
    assert "eleven_values: no score → 11" in found.stdout


def test_an_answer_without_a_recording_has_to_be_graded(tmp_path: Path) -> None:
    own = tmp_path / "own"
    command = grade_stored(tmp_path / "out", CRASHES, own, keep=False)
    (own / f"{STEM}.py").write_text(STRICTER)
    found = without_rclpy(REGRADE, *command)
    assert found.returncode == 1, found.stdout + found.stderr
    assert "Run `workbook grade` on the answers again" in found.stdout


def test_full_marks_for_the_beginning_of_a_script_stay_inconclusive(tmp_path: Path) -> None:
    exercise = load_exercise(STEM, ROOT)
    good = Recording.load(ROOT / "tests" / "recordings" / STEM / "solution.json")
    cut = replace(good, unpublished=(Published("/robot/imu", 9.0, 9.0, {}),))
    with ResultsFile(tmp_path / RESULTS) as file:
        for name, recording in (("cut", cut), ("whole", good)):
            judgement = replace(
                judge_recording(exercise, "a" * 64, recording), inconclusive_reason="the machine"
            )
            submission = Submission(name, f"{name}.py", "a" * 64)
            file.append(graded_result(submission, [judgement], GradedBy(exercise, "sandbox", tmp_path)))
    regrade(tmp_path, replace(exercise, criteria_sha256="b" * 64))
    results = last_results(tmp_path / RESULTS)
    assert "before 1 message of the script was sent" in results["cut", STEM].inconclusive_reason
    assert results["whole", STEM].inconclusive_reason == "", (
        "nothing is lost that the machine could have taken"
    )


def test_results_that_only_another_recording_showed_are_not_judged_again(tmp_path: Path) -> None:
    exercise = load_exercise(STEM, ROOT)
    good = Recording.load(ROOT / "tests" / "recordings" / STEM / "solution.json")
    kept = replace(good, notes=(f"{KEPT}joint_rate",))
    with ResultsFile(tmp_path / RESULTS) as file:
        judgement = judge_recording(exercise, "a" * 64, kept)
        file.append(
            graded_result(
                Submission("both", "both.py", "a" * 64),
                [judgement],
                GradedBy(exercise, "sandbox", tmp_path),
            )
        )
    [found] = regrade(tmp_path, replace(exercise, criteria_sha256="b" * 64))
    assert "a run in simulated time decided some results" in found.problem


def test_the_criteria_of_every_exercise_need_no_rclpy() -> None:
    found = without_rclpy(LOAD_ALL, *stems(ROOT / "solutions"))
    assert found.stdout == "loaded\n", found.stderr
