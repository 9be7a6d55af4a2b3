"""results.jsonl and grades.csv: the formats that other tools rely on."""

import csv
import io
import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from workbook.cli.main import main
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.grading.grades_csv import grades_csv, safe_cell
from workbook.grading.new_results import GradedBy, Submission, graded_result, ungradable_result
from workbook.grading.results import Result
from workbook.grading.results_file import ResultsFile, last_results, line_of, read_results
from workbook.recording.recording import Recording

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
KEYS = [
    "student",
    "answer",
    "answer_sha256",
    "submitted_at",
    "exercise",
    "attempt",
    "status",
    "reason",
    "score",
    "max_score",
    "criteria",
    "process",
    "recording",
    "clock",
    "robot_s",
    "wall_s",
    "isolation",
    "versions",
    "doubt",
    "tries",
    "why_this_try",
]
CRITERION_KEYS = "id title status points max_points hidden saw expected because try".split()
SHA = "a" * 64
EXERCISE = replace(load_exercise(STEM, ROOT), criteria_sha256="b" * 64)


def judged(name: str) -> Judgement:
    recording = Recording.load(ROOT / "tests" / "recordings" / STEM / f"{name}.json")
    return judge_recording(load_exercise(STEM, ROOT), SHA, recording)


def graded(out: Path, judgement: Judgement, student: str = "s1042", attempt: int = 1) -> Result:
    submission = Submission(student, f"{student}.py", SHA, attempt=attempt)
    return graded_result(submission, [judgement], GradedBy(EXERCISE, "limits", out))


def refused(student: str = "s1043", reason: str = "the answer is empty", answer: str = "s1043.py") -> Result:
    submission = Submission(student, answer, SHA, "2025-01-31T12:00:00Z")
    return ungradable_result(submission, reason, GradedBy(EXERCISE, "limits", Path()))


# --- results.jsonl ------------------------------------------------------------------------------------------------


def test_a_graded_result_has_exactly_the_keys_of_the_contract(tmp_path: Path) -> None:
    result = json.loads(line_of(graded(tmp_path, judged("eleven_values"))))
    assert list(result) == KEYS
    assert (result["status"], result["reason"], result["score"], result["max_score"]) == (
        "graded",
        None,
        9,
        10,
    )
    assert [list(one) for one in result["criteria"]] == [CRITERION_KEYS] * 9
    assert list(result["process"]) == ["exit", "signal", "limits_hit", "log"]
    assert list(result["versions"])[:3] == ["workbook", "criteria", "rclpy"]
    assert result["versions"]["criteria"] == "b" * 64
    assert (result["clock"], result["isolation"], result["attempt"]) == ("simulated", "limits", 1)
    assert result["robot_s"] == 14.0
    lost = [one for one in result["criteria"] if one["status"] != "passed"]
    assert [(one["id"], one["points"], one["max_points"]) for one in lost] == [("twelve_values", 0.0, 1)]
    assert sum(one["points"] for one in result["criteria"]) == result["score"]


def test_the_recording_is_stored_beside_the_results(tmp_path: Path) -> None:
    result = graded(tmp_path, judged("solution"))
    assert result.recording is not None
    assert result.recording.startswith("recordings/")
    stored = Recording.load(tmp_path / result.recording)
    assert stored == judged("solution").recording
    assert not list((tmp_path / "recordings").glob("*.part"))


def test_an_ungradable_result_has_no_score(tmp_path: Path) -> None:
    result = json.loads(line_of(refused()))
    assert list(result) == KEYS
    assert (result["status"], result["score"], result["max_score"]) == ("ungradable", None, 10)
    assert result["reason"] == "the answer is empty"
    assert result["criteria"] == []


def test_an_error_of_ours_is_no_zero(tmp_path: Path) -> None:
    ours = Judgement(STEM, SHA, "infra_error", "the slot ended with code -9", (), None)
    result = json.loads(line_of(graded(tmp_path, ours)))
    assert list(result) == KEYS
    assert (result["status"], result["score"], result["recording"], result["process"]) == (
        "infra_error",
        None,
        None,
        None,
    )
    assert "-9" in result["reason"]


def test_a_log_is_cut_to_eight_kilobytes(tmp_path: Path) -> None:
    judgement = judged("raises_at_once")
    assert judgement.recording is not None
    result = graded(tmp_path, judgement)
    assert result.process is not None
    assert len(result.process.log.encode()) <= 8_200


def append(path: Path, *results: Result) -> None:
    book = ResultsFile(path)
    for result in results:
        book.append(result)
    book.close()


def test_two_graders_do_not_write_to_one_folder(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out, answers = tmp_path / "out", tmp_path / "answers"
    answers.mkdir()
    (answers / f"{STEM}.py").write_text("def broken(:\n")
    first = ResultsFile(out / "results.jsonl")
    grade = ["grade", "--exercise", STEM, str(answers), "--out", str(out), "--isolation", "limits"]
    assert main(grade) == 2
    assert main(["grade", "--exercise", STEM, "--regrade", "--out", str(out)]) == 2
    said = [line for line in capsys.readouterr().err.splitlines() if line.startswith("workbook grade:")]
    assert [f"another `workbook grade` is writing to {out}" in line and "--out" in line for line in said] == [
        True,
        True,
    ]
    assert not list(read_results(out / "results.jsonl"))
    first.close()
    assert main(grade) == 0
    assert len(list(read_results(out / "results.jsonl"))) == 1


def test_the_last_line_of_a_student_counts(tmp_path: Path) -> None:
    path = tmp_path / "out" / "results.jsonl"
    first = graded(tmp_path, judged("wrong_name"))
    second = graded(tmp_path, judged("solution"), attempt=2)
    append(path, first, refused())
    append(path, second)
    assert [result.attempt for result in read_results(path)] == [1, 1, 2]
    last = last_results(path)
    assert set(last) == {("s1042", STEM), ("s1043", STEM)}
    assert last["s1042", STEM].score == 10


@pytest.mark.parametrize(
    "torn", ['{"student": "s1044", "exerci', '{"student": "s1044"', "{", "\x00\x00", '"']
)
def test_a_torn_last_line_is_ignored_and_dropped(torn: str, tmp_path: Path) -> None:
    path = tmp_path / "results.jsonl"
    append(path, refused("s1042"))
    with path.open("a") as file:
        file.write(torn)
    assert [result.student for result in read_results(path)] == ["s1042"]
    append(path, refused("s1044"))
    assert [result.student for result in read_results(path)] == ["s1042", "s1044"]
    assert all(json.loads(line) for line in path.read_text().splitlines())


def test_half_written_recordings_of_a_killed_run_are_removed(tmp_path: Path) -> None:
    graded(tmp_path, judged("solution"))
    [whole] = (tmp_path / "recordings").iterdir()
    (tmp_path / "recordings" / "abc.4242.part").write_text('{"format": 1,')
    append(tmp_path / "results.jsonl", refused())
    assert list((tmp_path / "recordings").iterdir()) == [whole]


def test_a_complete_line_without_newline_was_not_finished(tmp_path: Path) -> None:
    path = tmp_path / "results.jsonl"
    path.write_text(line_of(refused()).rstrip("\n"))
    assert list(read_results(path)) == []


@pytest.mark.parametrize("junk", ["not json\n", "[]\n", "{}\n", "\n", "null\n"])
def test_a_foreign_line_hides_nothing_behind_it(junk: str, tmp_path: Path) -> None:
    path = tmp_path / "results.jsonl"
    path.write_text(junk)
    append(path, refused("s1042"))
    assert [result.student for result in read_results(path)] == ["s1042"]


def test_no_results_yet(tmp_path: Path) -> None:
    assert last_results(tmp_path / "results.jsonl") == {}


@given(st.integers(0, 2000))
@settings(deadline=None, derandomize=True, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_a_file_cut_anywhere_loses_at_most_the_last_line(tmp_path: Path, cut: int) -> None:
    path = tmp_path / "results.jsonl"
    path.unlink(missing_ok=True)
    append(path, *(refused(f"s{number}", reason="größer als 1 MB") for number in range(4)))
    raw = path.read_bytes()
    kept = raw[: min(cut, len(raw))]
    path.write_bytes(kept)
    whole = kept.count(b"\n")
    assert len(list(read_results(path))) == whole
    append(path, refused("s9"))
    assert [result.student for result in read_results(path)][whole:] == ["s9"]


# --- grades.csv ---------------------------------------------------------------------------------------------------


def table(*results: Result) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(grades_csv(results))))


def test_one_row_per_student_with_points_by_criterion(tmp_path: Path) -> None:
    rows = table(graded(tmp_path, judged("wrong_name"), "s2"), graded(tmp_path, judged("solution"), "s1"))
    assert [(row["student"], row["score"], row["max_score"], row["status"]) for row in rows] == [
        ("s1", "10", "10", "graded"),
        ("s2", "3", "10", "graded"),
    ]
    assert (rows[0]["joint_topic"], rows[1]["joint_topic"], rows[1]["twelve_values"]) == ("2", "0", "0")
    assert "program_runs" not in rows[0], "a criterion without points has no column"


def test_without_a_score_the_cell_is_empty_and_never_zero(tmp_path: Path) -> None:
    [row, whole] = table(refused("s1"), graded(tmp_path, judged("solution"), "s2"))
    assert (row["score"], row["joint_topic"], row["clock"]) == ("", "", "")
    assert row["reason"] == "the answer is empty"
    assert whole["score"] == "10"


@pytest.mark.parametrize(
    ("value", "cell"),
    [
        ("=1+1", "'=1+1"),
        ("+49 170", "'+49 170"),
        ("-2+3", "'-2+3"),
        ("@SUM(A1)", "'@SUM(A1)"),
        ("\t=1+1", "'=1+1"),
        ("\r\n=cmd|' /C calc'!A0", "'=cmd|' /C calc'!A0"),
        (" =1", "'=1"),
        ("＝1+1", "'＝1+1"),
        ("\x00-1", "'-1"),
        ("\u2028=1", "'=1"),
        ("Müller, Jörg", "Müller, Jörg"),
        ("王小明", "王小明"),
        ("line\nbreak", "line break"),
        ("\x1b[31mred", "[31mred"),
        (None, ""),
        (8.5, "8.5"),
        (10.0, "10"),
        (-1.5, "-1.5"),
        ("", ""),
    ],
)
def test_no_cell_is_a_formula(value: Any, cell: str) -> None:
    assert safe_cell(value) == cell


@given(st.text())
@settings(deadline=None, derandomize=True)
def test_no_text_becomes_a_formula_or_a_second_line(text: str) -> None:
    cell = safe_cell(text)
    assert not cell.startswith(("=", "+", "-", "@", "\t", "\r", "\n"))
    assert len(cell.splitlines()) <= 1


@given(st.lists(st.text(st.characters(exclude_categories=["Cs"])), min_size=1, max_size=4, unique=True))
@settings(deadline=None, derandomize=True)
def test_any_student_names_make_a_table_with_a_row_each(names: list[str]) -> None:
    text = grades_csv([refused(name, answer=f"{name}.py") for name in names])
    rows = list(csv.reader(io.StringIO(text)))
    assert len(rows) == len(names) + 1
    assert {len(row) for row in rows} == {len(rows[0])}
