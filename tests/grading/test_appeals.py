"""Points that a person changed: they appear in every export with the reason, survive regrading, or are refused."""

import csv
import json
from dataclasses import replace
from pathlib import Path

import pytest

from workbook.cli.main import main
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import judge_recording
from workbook.grading.appeals import OVERRIDES, kept
from workbook.grading.new_results import GradedBy, Submission, graded_result, ungradable_result
from workbook.grading.pages import page_name
from workbook.grading.results_file import RESULTS, ResultsFile, last_results
from workbook.recording.recording import Recording

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
EXERCISE = load_exercise(STEM, ROOT)
FORMATS = "html,gradescope,canvas,moodle,nbgrader"
CHANGE = (
    "ada,joint_positions,twelve_values,1,The twelfth value was <b>lost</b> by a fault of the lab,Dr. Lee\n"
)


@pytest.fixture
def out(tmp_path: Path) -> Path:
    """Store results: ada lost a point, bob has full marks, and eve is ungradable."""
    folder = tmp_path / "out"
    by = GradedBy(EXERCISE, "sandbox", folder)
    with ResultsFile(folder / RESULTS) as file:
        for student, name in (("ada", "eleven_values"), ("bob", "solution")):
            stored = Recording.load(ROOT / "tests" / "recordings" / STEM / f"{name}.json")
            judgement = judge_recording(EXERCISE, "a" * 64, stored)
            file.append(graded_result(Submission(student, f"{student}.py", "a" * 64), [judgement], by))
        file.append(ungradable_result(Submission("eve", "eve.py", ""), "the answer is empty", by))
    return folder


def change(out: Path, text: str, *more: str) -> int:
    file = out.parent / "appeals.csv"
    file.write_text(text, encoding="utf-8")
    command = ["grade", "--override", str(file), "--exercise", STEM, "--out", str(out), "--format", FORMATS]
    return main([*command, *more])


def table(path: Path) -> dict[str, dict[str, str]]:
    with path.open(newline="", encoding="utf-8-sig") as file:
        rows = list(csv.DictReader(file))
    return {next(iter(row.values())): row for row in rows}


def scores(out: Path) -> dict[str, str]:
    return {name: row["score"] for name, row in table(out / "grades.csv").items()}


def test_a_change_is_in_every_export_and_results_are_left_alone(out: Path) -> None:
    before = (out / RESULTS).read_bytes()
    assert change(out, CHANGE) == 0
    assert (out / RESULTS).read_bytes() == before
    ada = table(out / "grades.csv")["ada"]
    assert (ada["score"], ada["twelve_values"]) == ("10", "1")
    assert "Changed by Dr. Lee" in ada["remark"] and "a fault of the lab" in ada["remark"]
    assert list(table(out / "canvas.csv")["ada"].values())[-1] == "10"
    moodle = list(table(out / "moodle.csv")["ada"].values())
    assert moodle[1] == "10" and "a fault of the lab" in moodle[2]
    with (out / "nbgrader.csv").open(newline="") as file:
        nbgrader = {row["student_id"]: row["score"] for row in csv.DictReader(file)}
    assert nbgrader == {"ada": "10", "bob": "10", "eve": ""}
    page = page_name("ada", STEM)
    data = json.loads((out / "gradescope" / page).with_suffix(".json").read_text())
    assert data["score"] == sum(test["score"] for test in data["tests"]) == 10
    assert "a fault of the lab" in data["output"]
    shown = (out / "pages" / page).read_text()
    assert "a fault of the lab" in shown and "Dr. Lee" in shown and "Score: 10 of 10" in shown
    assert "<b>lost</b>" not in shown
    assert "a fault of the lab" not in (out / "pages" / page_name("bob", STEM)).read_text()


def test_a_change_survives_regrading_under_other_criteria(
    out: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert change(out, CHANGE) == 0
    own = tmp_path / "own"
    own.mkdir()
    (own / f"{STEM}.py").write_text(
        "import workbook.criteria as see\n"
        "from workbook.criteria import Recording, Verdict, criterion\n\n\n"
        "@criterion(points=2, title='Seen')\n"
        "def seen_by_me(recording: Recording) -> Verdict:\n"
        "    return see.passed('seen')\n"
    )
    monkeypatch.setenv("WORKBOOK_CRITERIA", "")
    command = ["grade", "--regrade", "--exercise", STEM, "--out", str(out), "--criteria", str(own)]
    assert main(command) == 0
    assert last_results(out / RESULTS)["ada", STEM].attempt == 2
    assert scores(out) == {"ada": "12", "bob": "12", "eve": ""}


def test_a_change_survives_a_run_that_goes_on(out: Path, tmp_path: Path) -> None:
    assert change(out, CHANGE) == 0
    (tmp_path / "class").mkdir()
    (tmp_path / "class" / "zoe.py").write_text("")
    command = [
        "grade",
        str(tmp_path / "class" / "zoe.py"),
        "--exercise",
        STEM,
        "--out",
        str(out),
        "--isolation",
        "limits",
    ]
    assert main(command) == 0
    assert scores(out) == {"ada": "10", "bob": "10", "eve": "", "zoe": ""}


def test_a_change_that_takes_points_away_is_reported(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """As after a criterion was corrected and now gives more points than the change."""
    assert change(out, f"bob,{STEM},total,7,generous,Dr. Lee\n") == 0
    told = capsys.readouterr().out
    assert "bob: the judge gives 10 points for total, and the change by Dr. Lee lowers them to 7." in told
    assert change(out, CHANGE) == 0
    assert "ada: the judge gives" not in capsys.readouterr().out


def test_a_change_comes_before_lateness(out: Path) -> None:
    with ResultsFile(out / RESULTS) as file:
        file.append(replace(last_results(out / RESULTS)["ada", STEM], submitted_at="2025-01-02T00:00Z"))
    assert change(out, CHANGE, "--deadline", "2025-01-01T12:00Z", "--late-per-day", "0.1") == 0
    assert scores(out)["ada"] == "9"


def test_the_score_as_a_whole_may_be_given_also_to_what_could_not_be_judged(out: Path) -> None:
    assert change(out, f"eve,{STEM},total,7.5,handed in on paper,Dr. Lee\n") == 0
    row = table(out / "grades.csv")["eve"]
    assert (row["score"], row["status"]) == ("7.5", "graded")
    page = (out / "pages" / page_name("eve", STEM)).read_text()
    assert "Score: 7.5 of 10" in page and "handed in on paper" in page
    assert "Full marks" not in page


def test_a_later_line_counts_and_empty_points_take_a_change_back(out: Path) -> None:
    head = "student,exercise,criterion,points,reason,who\n"
    assert change(out, head + CHANGE) == 0
    assert change(out, head + CHANGE.replace(",1,", ",0.5,")) == 0
    assert scores(out)["ada"] == "9.5"
    assert change(out, head + CHANGE.replace(",1,", ",,")) == 0
    assert scores(out)["ada"] == "9"
    assert kept(out) == []
    assert (out / OVERRIDES).read_text().count("\n") == 3, "nothing is forgotten"


def test_another_answer_is_judged_as_ever_and_it_is_said(
    out: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert change(out, CHANGE) == 0
    with ResultsFile(out / RESULTS) as file:
        file.append(replace(last_results(out / RESULTS)["ada", STEM], answer_sha256="b" * 64))
    capsys.readouterr()
    assert change(out, f"bob,{STEM},twelve_values,0,copied,Dr. Lee\n") == 0
    assert scores(out) == {"ada": "9", "bob": "9", "eve": ""}
    assert (
        "twelve_values is not applied, because it was made for an earlier answer" in capsys.readouterr().out
    )


@pytest.mark.parametrize(
    ("line", "words"),
    [
        ("adda,joint_positions,twelve_values,1,why,me", "'adda' has no result in 09_joint_positions"),
        (
            "ada,timers,twelve_values,1,why,me",
            "no results of an exercise timers. There are 09_joint_positions",
        ),
        ("ada,joint_positions,thirteen_values,1,why,me", "no criterion 'thirteen_values'. There are"),
        ("eve,joint_positions,twelve_values,1,why,me", "There are total"),
        ("ada,joint_positions,twelve_values,7,why,me", "7 points are more than the 1 that it is worth"),
        ("ada,joint_positions,twelve_values,-1,why,me", "'-1' is not a number of points"),
        ("ada,joint_positions,twelve_values,nan,why,me", "'nan' is not a number of points"),
        ("ada,joint_positions,twelve_values,all,why,me", "'all' is not a number of points"),
        ("ada,joint_positions,twelve_values,1,,me", "the column `reason` is empty"),
        ("ada,joint_positions,twelve_values,1,why,", "the column `who` is empty"),
        ("ada,joint_positions,twelve_values,1", "this line has 4 columns"),
        ("bob,09_joint_positions,twelve_values,0,again,me", "an earlier line changes the same criterion"),
    ],
)
def test_a_line_that_fits_nobody_is_refused_with_its_number_and_nothing_is_taken(
    out: Path, line: str, words: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert change(out, f"bob,{STEM},twelve_values,0,copied,Dr. Lee\n\n{line}\n") == 2
    said = capsys.readouterr().err
    assert "appeals.csv, line 3: " in said
    assert words in said
    assert "Correct the line and run the command again; nothing in this file was applied" in said
    assert kept(out) == []


def test_a_broken_line_of_those_that_are_kept_stops_the_grader_before_it_judges(
    out: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (out / OVERRIDES).write_text("[" * 100_000 + "\n")
    assert change(out, CHANGE) == 2
    assert "overrides.jsonl, line 1, holds no change of a mark" in capsys.readouterr().err


def test_a_change_is_found_by_the_name_that_grades_csv_shows(out: Path) -> None:
    with ResultsFile(out / RESULTS) as file:
        file.append(replace(last_results(out / RESULTS)["ada", STEM], student="=ada\n"))
    assert change(out, CHANGE) == 0
    [name] = [one for one in table(out / "grades.csv") if one.startswith("'=ada")]
    assert change(out, CHANGE.replace("ada", f'"{name}"', 1)) == 0
    assert {scores(out)[one] for one in ("ada", name)} == {"10"}


def test_changing_marks_needs_results_and_an_exercise(out: Path, tmp_path: Path) -> None:
    file = tmp_path / "appeals.csv"
    file.write_text(CHANGE)
    assert main(["grade", "--override", str(file), "--exercise", STEM, "--out", str(tmp_path / "no")]) == 2
    assert main(["grade", "--override", str(file), "--out", str(out)]) == 2
    assert change(out, "\n") == 2
