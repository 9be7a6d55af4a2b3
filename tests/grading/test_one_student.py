"""A gradebook's data about one student can be found, exported, and erased, without affecting other students."""

import csv
import json
import unicodedata
import zipfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest

from workbook.cli.main import main
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import judge_recording
from workbook.grading.appeals import OVERRIDES, keep
from workbook.grading.changes import Override
from workbook.grading.gradebook import GradebookOptions, write_gradebook
from workbook.grading.lateness import Lateness, parse_moment
from workbook.grading.new_results import GradedBy, Submission, graded_result
from workbook.grading.results import Result
from workbook.grading.results_file import RESULTS, ResultsFile, last_results
from workbook.recording.recording import Recording

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
EXERCISE = load_exercise(STEM, ROOT)
RENE = unicodedata.normalize("NFC", "René Zoë")
RENE_ON_A_MAC = unicodedata.normalize("NFD", RENE)
NAMES = ("Zoe", RENE, RENE_ON_A_MAC, "=x", 'Lovelace, "Ada"', "Ré", "a\nb")
FORMATS = ("html", "canvas", "moodle", "nbgrader", "gradescope")
STORED = {
    name: Recording.load(ROOT / "tests" / "recordings" / STEM / f"{name}.json")
    for name in ("solution", "eleven_values")
}


def result(out: Path, student: str, recording: str, number: int) -> Result:
    """Make a result with a recording.

    Results with number 0 share one recording; each other number has a different one.
    """
    stored = replace(STORED[recording], domain_id=number)
    judgement = judge_recording(EXERCISE, "a" * 64, stored)
    submission = Submission(student, f"{student}.py", judgement.answer_sha256, "2026-05-31T12:00+00:00")
    return graded_result(submission, [judgement], GradedBy(EXERCISE, "sandbox", out))


def gradebook(out: Path, names: Sequence[str], lateness: Lateness | None = None) -> Path:
    with ResultsFile(out / RESULTS) as file:
        for number, name in enumerate(names, start=1):
            file.append(result(out, name, "eleven_values", number))
            file.append(result(out, name, "solution", 0))
    keep(out, [Override(name, STEM, "total", 7.0, "agreed", "me", "a" * 64) for name in names[:3]])
    write_gradebook(out, EXERCISE, last_results(out / RESULTS), GradebookOptions(FORMATS, lateness))
    return out


@pytest.fixture
def out(tmp_path: Path) -> Path:
    return gradebook(tmp_path / "out", NAMES)


def files(folder: Path) -> dict[str, bytes]:
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def student(action: str, name: str, out: Path, *more: object) -> int:
    return main(["student", action, name, "--out", str(out), *map(str, more)])


def test_listing_names_everything_and_changes_nothing(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = files(out)
    assert student("list", "Zoe", out) == 0
    said = capsys.readouterr().out
    for part in (
        "results.jsonl: 2 lines",
        "overrides.jsonl: 1 line",
        "grades.csv: 1 line",
        "canvas.csv: 1 line",
    ):
        assert part in said
    assert said.count("recordings/") == 2
    assert said.count("another student's result needs it, too") == 1
    assert f"pages/{STEM}-zoe-" in said and f"gradescope/{STEM}-zoe-" in said
    assert "The hand-ins aren't in the gradebook, so they stay: Zoe.py." in said
    assert files(out) == before


@pytest.mark.parametrize("name", NAMES)
def test_erasing_leaves_nothing_of_a_student_and_all_of_the_others(out: Path, name: str) -> None:
    alike = {one for one in NAMES if unicodedata.normalize("NFC", one) == unicodedata.normalize("NFC", name)}
    before = files(out)
    assert student("erase", name, out) == 0
    reference = gradebook(out.parent / "reference", [one for one in NAMES if one not in alike])
    assert len(files(out)) == len(files(reference))
    rest = last_results(out / RESULTS)
    assert {one for one, _ in rest} == set(NAMES) - alike
    others = [line for line in before[RESULTS].splitlines() if json.loads(line)["student"] not in alike]
    assert (out / RESULTS).read_bytes().splitlines() == others
    for one in rest.values():
        assert one.recording is not None and (out / one.recording).is_file()
    with (out / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
        assert len(list(csv.DictReader(file))) == len(NAMES) - len(alike)
    kept = [json.loads(line)["student"] for line in (out / OVERRIDES).read_text().splitlines()]
    assert kept == [one for one in NAMES[:3] if one not in alike]
    page = (out / "pages" / "class.html").read_text(encoding="utf-8")
    assert page.count(f'<a href="{STEM}-') > 0
    assert f">{name}<" not in page


def test_names_that_look_alike_are_one_student(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert student("list", RENE_ON_A_MAC, out) == 0
    assert "results.jsonl: 4 lines" in capsys.readouterr().out


def test_a_name_as_the_tables_write_it_is_understood(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with (out / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
        [cell] = [row["student"] for row in csv.DictReader(file) if row["student"].startswith("'=x")]
    assert student("list", cell, out) == 0
    assert "results.jsonl: 2 lines" in capsys.readouterr().out


def test_a_student_that_is_unknown_is_refused_with_similar_names(
    out: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = files(out)
    assert student("erase", "zoe", out) == 2
    assert "knows no student zoe. Similar names: Zoe" in capsys.readouterr().err
    assert student("erase", "qqqqq", out) == 2
    assert "Similar" not in capsys.readouterr().err
    assert files(out) == before


@pytest.mark.parametrize("name", [RESULTS, OVERRIDES])
def test_a_torn_file_is_refused(out: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    with (out / name).open("a") as file:
        file.write('{"student": "Zo')
    before = files(out)
    assert student("erase", "Zoe", out) == 2
    assert "incomplete" in capsys.readouterr().err
    assert files(out) == before


@pytest.mark.parametrize("name", [RESULTS, OVERRIDES])
def test_a_line_that_nobody_can_read_may_be_the_students(
    out: Path, name: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with (out / name).open("a") as file:
        file.write('{"student": "Zoe"}\n')
    before = files(out)
    assert student("export", "Zoe", out, "--to", out.parent / "x.zip") == 2
    assert "restore it, or delete it" in capsys.readouterr().err
    assert files(out) == before


def test_a_running_grader_is_not_disturbed(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with ResultsFile(out / RESULTS):
        assert student("erase", "Zoe", out) == 2
    assert "another `workbook grade` is writing" in capsys.readouterr().err


def test_a_folder_that_is_no_gradebook_is_refused_and_left_alone(tmp_path: Path) -> None:
    assert student("list", "Zoe", tmp_path) == 2
    assert list(tmp_path.iterdir()) == []


def test_the_archive_holds_everything_of_the_student_and_nothing_else(out: Path) -> None:
    before = files(out)
    archive = out.parent / "zoe.zip"
    assert student("export", "Zoe", out, "--to", archive) == 0
    with zipfile.ZipFile(archive) as zipped:
        assert zipped.testzip() is None
        names = zipped.namelist()
        lines = [json.loads(line) for line in zipped.read(RESULTS).splitlines()]
        table = zipped.read("grades.csv").decode("utf-8-sig").splitlines()
    assert [one["student"] for one in lines] == ["Zoe", "Zoe"]
    assert len(table) == 2 and table[0].startswith("student,") and table[1].startswith("Zoe,")
    assert sum(name.startswith("recordings/") for name in names) == 2
    assert not any("class" in name for name in names)
    assert files(out) == before
    assert student("export", "Zoe", out, "--to", archive) == 2


def test_lines_of_the_instructors_own_lists_are_found_and_erased(
    out: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    aliases = out.parent / "who.csv"
    aliases.write_bytes(f'\ufeffupload_1,Zoe\r\n"upload\n2",{RENE_ON_A_MAC}\r\nupload_3,Zoey\r\n'.encode())
    assert student("list", RENE, out, "--also", aliases) == 0
    assert "who.csv: 1 line\n" in capsys.readouterr().out
    assert student("erase", RENE, out, "--also", aliases) == 0
    assert aliases.read_bytes() == "\ufeffupload_1,Zoe\r\nupload_3,Zoey\r\n".encode()
    assert student("erase", "Zoe", out, "--also", aliases) == 0
    assert aliases.read_bytes() == b"upload_3,Zoey\r\n"


def test_the_marks_of_others_stay_as_lateness_has_left_them(tmp_path: Path) -> None:
    deadline = parse_moment("2026-05-30T12:00+00:00")
    assert deadline is not None
    out = gradebook(tmp_path / "out", ["ada", "bob", "cyd", "dan"], Lateness(deadline, 0.1))
    before = (out / "grades.csv").read_text().splitlines()
    assert student("erase", "dan", out) == 0
    assert (out / "grades.csv").read_text().splitlines() == [
        one for one in before if not one.startswith("dan,")
    ]
    gradebook(tmp_path / "reference", ["ada", "bob", "cyd"], Lateness(deadline, 0.1))
    page = (out / "pages" / "class.html").read_text()
    assert page == (tmp_path / "reference" / "pages" / "class.html").read_text()


def test_a_recording_that_leads_elsewhere_is_left_alone(tmp_path: Path) -> None:
    precious = tmp_path / "precious.json"
    precious.write_text("{}")
    out = tmp_path / "out"
    with ResultsFile(out / RESULTS) as file:
        file.append(replace(result(out, "ada", "solution", 1), recording="../precious.json"))
    assert student("erase", "ada", out) == 0
    assert precious.read_text() == "{}"
