"""Exports of the gradebook: each follows its system's rules, whatever the students are called."""

import csv
import io
import json
import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from datetime import datetime
from html.parser import HTMLParser
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbook.cli.grade_screen import conclude_regrading
from workbook.exercise.definition import OWN_CRITERIA, load_exercise
from workbook.exercise.judgement import judge_recording
from workbook.feedback.text import as_text
from workbook.grading.class_page import class_page
from workbook.grading.exports import NBGRADER, canvas, gradescope, moodle, nbgrader
from workbook.grading.github import Pushed, classroom, summary
from workbook.grading.gradebook import GradebookOptions, write_gradebook
from workbook.grading.grades_csv import grades_csv
from workbook.grading.gradescope import results_json
from workbook.grading.lateness import Lateness, parse_moment, with_lateness
from workbook.grading.new_results import GradedBy, Submission, graded_result, ungradable_result
from workbook.grading.pages import CLASS, judgement_of, page_name, student_page
from workbook.grading.regrade import regrade
from workbook.grading.results import Result
from workbook.grading.results_file import RESULTS, ResultsFile, last_results
from workbook.grading.roster import BadOption, read_aliases
from workbook.recording.recording import Recording

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
EXERCISE = load_exercise(STEM, ROOT)
ODD_NAMES = [
    'Lovelace, Ada "Al"',
    "=HYPERLINK(1)",
    "🤖 Marvin",
    "\u202eevil",
    "نور",
    "<b>x</b>",
    "a\nb",
    "-1+2",
    "@all",
]


def result(out: Path, student: str, recording: str = "solution", submitted_at: str | None = None) -> Result:
    stored = Recording.load(ROOT / "tests" / "recordings" / STEM / f"{recording}.json")
    judgement = judge_recording(EXERCISE, "a" * 64, stored)
    submission = Submission(student, f"{student}.py", judgement.answer_sha256, submitted_at)
    return graded_result(submission, [judgement], GradedBy(EXERCISE, "sandbox", out))


def refused(student: str) -> Result:
    by = GradedBy(EXERCISE, "sandbox", Path())
    return ungradable_result(Submission(student, "x.py", ""), "the file is empty", by)


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory) -> Result:
    return result(tmp_path_factory.mktemp("out"), "ada", "eleven_values")


def rows(text: str) -> list[list[str]]:
    return list(csv.reader(io.StringIO(text)))


# --- each system's rules ------------------------------------------------------------------------------------------


def test_gradescope_gets_tests_whose_points_add_up(plain: Result) -> None:
    data = json.loads(gradescope(plain))
    assert data["score"] == sum(test["score"] for test in data["tests"]) == 9.0
    assert sum(test["max_score"] for test in data["tests"]) == 10.0
    allowed = {"hidden", "after_due_date", "after_published", "visible"}
    for test in data["tests"]:
        assert test["visibility"] in allowed
        assert test["status"] in ("passed", "failed")
        assert (test["status"] == "passed") == (test["score"] == test["max_score"])
    failed = next(test for test in data["tests"] if test["status"] == "failed")
    assert "11 values" in failed["output"]


def test_gradescope_gets_no_zero_for_what_could_not_be_graded() -> None:
    data = json.loads(gradescope(refused("bob")))
    assert "score" not in data
    assert data["tests"] == []
    assert "the file is empty" in data["output"]


def test_a_hidden_criterion_is_hidden_in_gradescope(plain: Result) -> None:
    lines = tuple(replace(one, hidden=one.id == "twelve_values") for one in plain.criteria)
    hidden = replace(plain, criteria=lines)
    data = json.loads(gradescope(hidden))
    assert [test["visibility"] for test in data["tests"]].count("hidden") == 1
    assert "11 values" not in data["output"]


def test_canvas_finds_its_columns(plain: Result) -> None:
    head, possible, first = rows(canvas([plain], "Exercise 09 (12345)", 10.0))
    assert "Student" in head[0] and "ID" in head[1]
    assert head[4] == "Section"
    assert re.fullmatch(r"(.*)\s\((\d+)\)", head[5])
    assert "Points Possible" in possible[0]
    assert first == ["ada", "", "", "ada", "", "9"]


def test_moodle_gets_only_those_with_a_grade(plain: Result) -> None:
    head, *found = rows(moodle([plain, refused("bob")], "Exercise 09"))
    assert head == ["ID number", "Exercise 09", "Exercise 09 (feedback)"]
    assert [row[:2] for row in found] == [["ada", "9"]]
    assert "11 values" in found[0][2]


def test_nbgrader_gets_its_own_columns(plain: Result) -> None:
    late = replace(plain, score=7.0, late_points=2.0, submitted_at="2026-05-01T10:00:00+00:00")
    head, first, second = rows(nbgrader([late, refused("bob")]))
    assert tuple(head) == NBGRADER
    entry = dict(zip(head, first, strict=True))
    assert (entry["raw_score"], entry["late_submission_penalty"], entry["score"]) == ("9", "2", "7")
    assert dict(zip(head, second, strict=True))["score"] == ""


@given(st.one_of(st.text(min_size=1, max_size=60), st.sampled_from(ODD_NAMES)))
@settings(deadline=None, derandomize=True, max_examples=150)
def test_no_name_breaks_a_table_or_becomes_a_formula(name: str) -> None:
    odd = replace(refused(name), status="graded", score=3.0)
    for text in (canvas([odd], "X (1)", 10.0), moodle([odd], "X"), nbgrader([odd])):
        found = rows(text)
        assert len({len(row) for row in found}) == 1
        for row in found:
            for cell in row:
                assert not cell.startswith(("=", "+", "-", "@"))
                assert not re.search(r"[\x00-\x08\x0b-\x1f\x7f]", cell)


UNSEEN = "\u061c\u200b\ufeff\u2028\u2029\U000e0041\u202e\xad\u3164\x1b[2J"
TOLD = f"<img src=x> {UNSEEN}=1+1 & {UNSEEN}"


@pytest.fixture(scope="module")
def hostile(plain: Result) -> Result:
    """Make a result whose texts (those that an answer may influence) are malicious, as in an old file."""
    lines = tuple(
        replace(one, saw=TOLD, expected=TOLD, because=TOLD, try_this=TOLD) if one.is_lost else one
        for one in plain.criteria
    )
    process = None if plain.process is None else replace(plain.process, log=TOLD)
    return replace(plain, student=f"ada{UNSEEN}", answer=f"{TOLD}.py", criteria=lines, process=process)


EXPORTS: dict[str, Callable[[Result, Path], str]] = {
    "csv": lambda one, out: grades_csv([one]),
    "canvas": lambda one, out: canvas([one], "X (1)", 10.0),
    "moodle": lambda one, out: moodle([one], "X"),
    "nbgrader": lambda one, out: nbgrader([one]),
    "gradescope": lambda one, out: "".join(_texts(json.loads(gradescope(one)))),
    "results.json": lambda one, out: "".join(_texts(json.loads(results_json(one)))),
    "classroom": lambda one, out: "".join(_texts(classroom(Pushed(EXERCISE, one)))),
    "run of GitHub": lambda one, out: summary([Pushed(EXERCISE, one)], out, "sandbox"),
    "student's page": lambda one, out: student_page(one, EXERCISE, out),
    "page of the class": lambda one, out: class_page([one], EXERCISE),
    "terminal": lambda one, out: as_text(judgement_of(one, out)),
}


def _texts(data: object) -> Iterator[str]:
    if isinstance(data, dict):
        data = list(data.values())
    if isinstance(data, list):
        for one in data:
            yield from _texts(one)
    elif isinstance(data, str):
        yield data


@pytest.mark.parametrize("status", ["graded", "ungradable"])
@pytest.mark.parametrize("export", EXPORTS)
def test_no_export_holds_what_nobody_sees(export: str, status: str, hostile: Result, tmp_path: Path) -> None:
    one = hostile if status == "graded" else replace(hostile, status="ungradable", reason=TOLD, score=None)
    text = EXPORTS[export](one, tmp_path)
    assert text
    assert not [hex(ord(sign)) for sign in text if not sign.isprintable() and sign not in "\n\t\xa0\u3000"]
    assert "\u3164" not in text


def test_moodle_shows_feedback_as_it_is_and_not_as_html(hostile: Result) -> None:
    [_, [_, _, feedback]] = rows(moodle([hostile], "X"))
    assert not tags(feedback).found
    assert "seen &lt;img src=x&gt; =1+1 &amp;" in feedback


def test_no_cell_is_a_formula_behind_what_nobody_sees(hostile: Result) -> None:
    odd = replace(hostile, answer="\u200b=1+1", student="\ufeff=HYPERLINK(1)")
    [_, row] = rows(grades_csv([odd]))
    assert "'=1+1" in row
    assert not [cell for cell in row if cell.startswith("=")]


# --- pages --------------------------------------------------------------------------------------------------------


class Tags(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.found: list[tuple[str, dict[str, str | None]]] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.found.append((tag, dict(attrs)))


def tags(page: str) -> Tags:
    parser = Tags()
    parser.feed(page)
    return parser


@pytest.mark.parametrize("name", [*ODD_NAMES, "<script>alert(1)</script>", "../../etc/passwd", "x" * 300])
def test_a_page_shows_any_name_and_runs_nothing(tmp_path: Path, name: str) -> None:
    one = result(tmp_path, name, "eleven_values")
    page = student_page(one, EXERCISE, tmp_path)
    found = tags(page).found
    assert not {tag for tag, _ in found} & {"script", "iframe", "object", "b x"}
    assert not [attrs for _, attrs in found if any(key.startswith("on") for key in attrs)]
    for _, attrs in found:
        assert (attrs.get("src") or "data:").startswith("data:")
    assert any(tag == "img" and attrs.get("alt") for tag, attrs in found), "the timeline"
    assert re.fullmatch(r"[a-z0-9_-]+\.html", page_name(name, STEM))


def test_names_that_look_alike_have_pages_of_their_own() -> None:
    names = ["Ada B", "ada-b", "ada b", "ADA_B", "ädä"]
    assert len({page_name(name, STEM) for name in names}) == len(names)


def test_the_books_are_written_and_the_class_page_leads_to_everybody(tmp_path: Path) -> None:
    everything = {
        (one.student, STEM): one
        for one in (
            result(tmp_path, "ada"),
            result(tmp_path, "bob", "eleven_values"),
            result(tmp_path, "eve", "eleven_values"),
            refused("mallory"),
        )
    }
    formats = ("html", "gradescope", "canvas", "moodle", "nbgrader")
    written = write_gradebook(tmp_path, EXERCISE, everything, GradebookOptions(formats))
    assert all(path.exists() for path in written)
    page = (tmp_path / "pages" / CLASS).read_text(encoding="utf-8")
    for student in ("ada", "bob", "eve", "mallory"):
        link = page_name(student, STEM)
        assert link in page
        assert (tmp_path / "pages" / link).is_file()
    assert "2 × every message has 11 values" in page
    assert "the file is empty" in page
    assert len(list((tmp_path / "gradescope").glob("*.json"))) == 4


# --- options ------------------------------------------------------------------------------------------------------


def test_lateness_counts_days_begun_and_never_goes_below_zero(tmp_path: Path) -> None:
    deadline = parse_moment("2026-05-01T12:00:00+00:00")
    assert deadline is not None
    late = Lateness(deadline, 0.1)
    moments = {
        None: 10.0,
        "2026-05-01T11:59:59+00:00": 10.0,
        "2026-05-01T12:00:01": 9.0,
        "2026-05-02T14:00:00+02:00": 9.0,
        "2026-05-02T12:00:01Z": 8.0,
        "2026-05-01 12:00:00.123456 UTC": 9.0,
        "2026-05-02 12:00:01 GMT": 8.0,
        "2026-05-02 12:00:01 CEST": 10.0,
        "2026-07-01T00:00:00Z": 0.0,
        "yesterday": 10.0,
    }
    raw = [result(tmp_path, "ada", submitted_at=moment) for moment in moments]
    assert [one.score for one in with_lateness(raw, late)] == list(moments.values())
    assert {one.score for one in raw} == {10.0}
    assert [one.submitted_at for one in late.unknown(raw)] == [
        None,
        "2026-05-02 12:00:01 CEST",
        "yesterday",
    ]
    assert with_lateness([refused("bob")], late)[0].score is None


def test_a_moment_without_a_zone_is_utc() -> None:
    moment = parse_moment("2026-05-01 12:00:00")
    assert isinstance(moment, datetime)
    assert moment.utcoffset() is not None


def test_aliases_are_read(tmp_path: Path) -> None:
    file = tmp_path / "aliases.csv"
    file.write_text('\ufeffs1.py,Ada Lovelace\n\n"folder, odd","=1"\n', encoding="utf-8")
    assert read_aliases(file) == {"s1.py": "Ada Lovelace", "folder, odd": "=1"}


@pytest.mark.parametrize("text", ["s1.py\n", "s1.py,\n", "s1.py,ada\ns1.py,bob\n", "\x00"])
def test_a_wrong_alias_file_is_refused_with_its_line(tmp_path: Path, text: str) -> None:
    file = tmp_path / "aliases.csv"
    file.write_text(text)
    with pytest.raises(BadOption, match=r"aliases\.csv"):
        read_aliases(file)


# --- regrading ----------------------------------------------------------------------------------------------------

STRICTER = """
import workbook.criteria as see
from workbook.criteria import Recording, Verdict, criterion


@criterion(points=2, title="The joints were seen by the instructor")
def seen_by_me(recording: Recording) -> Verdict:
    if recording.topic("/robot/joint_positions").arrivals:
        return see.passed("seen")
    return see.failed("own.nothing", "nothing", "something", "silence", "speak")
"""


@pytest.fixture
def own_criteria(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "own"
    folder.mkdir()
    (folder / f"{STEM}.py").write_text(STRICTER)
    monkeypatch.setenv(OWN_CRITERIA, str(folder))
    return folder


def test_own_criteria_are_hidden_and_change_what_a_result_depends_on(own_criteria: Path) -> None:
    exercise = load_exercise(STEM, ROOT)
    assert [one.id for one in exercise.criteria if one.hidden] == ["seen_by_me"]
    assert exercise.max_points == EXERCISE.max_points + 2
    assert exercise.criteria_sha256 != EXERCISE.criteria_sha256


def test_regrading_runs_nothing_and_tells_whose_marks_changed(tmp_path: Path, own_criteria: Path) -> None:
    book = ResultsFile(tmp_path / RESULTS)
    for student, recording in (("ada", "solution"), ("bob", "wrong_name")):
        book.append(result(tmp_path, student, recording))
    book.append(replace(result(tmp_path, "eve"), recording="recordings/gone.json"))
    book.append(refused("mallory"))
    book.close()
    exercise = load_exercise(STEM, ROOT)
    found = {one.student: one for one in regrade(tmp_path, exercise)}
    assert (found["ada"].before, found["ada"].after, found["ada"].changed) == (10.0, 12.0, True)
    assert not found["bob"].changed
    assert "cannot be read" in found["eve"].problem
    assert "mallory" not in found
    now = last_results(tmp_path / RESULTS)
    assert now["ada", STEM].attempt == 2
    assert now["ada", STEM].versions.criteria == exercise.criteria_sha256
    assert now["eve", STEM].score == 10.0
    size = len((tmp_path / RESULTS).read_text())
    assert not any(one.changed for one in regrade(tmp_path, exercise))
    assert len((tmp_path / RESULTS).read_text()) == size


def test_regrading_lists_every_criterion_that_changed_and_not_only_sums(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    mine = result(tmp_path, "ada", "eleven_values")
    first, second = [one for one in mine.criteria if one.points >= 1][:2]
    others = [one for one in mine.criteria if one not in (first, second)]
    moved = (replace(first, points=first.points - 1), replace(second, points=second.points + 1))
    older = replace(mine, criteria=(*moved, *others))
    with ResultsFile(tmp_path / RESULTS) as file:
        file.append(older)
    [found] = regrade(tmp_path, EXERCISE)
    assert (found.before, found.after, found.changed) == (mine.score, mine.score, True)
    assert {one.id for one in found.criteria} == {first.id, second.id}
    conclude_regrading([found], STEM)
    assert f"    {first.id}: {first.points - 1:g} → {first.points:g}" in capsys.readouterr().out


def test_the_same_criteria_in_another_version_of_the_course_are_judged_again(tmp_path: Path) -> None:
    mine = result(tmp_path, "ada")
    older = replace(mine, versions=replace(mine.versions, workbook="0.0.9", rclpy="7.1.2", python="3.11.1"))
    with ResultsFile(tmp_path / RESULTS) as file:
        file.append(older)
    [found] = regrade(tmp_path, EXERCISE)
    assert not found.changed
    now = last_results(tmp_path / RESULTS)["ada", STEM]
    assert now.versions == replace(older.versions, workbook=mine.versions.workbook)


def test_the_pages_say_which_version_judged(tmp_path: Path) -> None:
    mine = result(tmp_path, "ada")
    older = replace(mine, student="bob", versions=replace(mine.versions, workbook="0.0.9"))
    told = f"workbook 0.0.9, criteria {EXERCISE.criteria_sha256[:12]}, rclpy"
    assert f"Judged by {told}" in student_page(older, EXERCISE, tmp_path)
    page = class_page([mine, older], EXERCISE)
    assert f"{told} {mine.versions.rclpy} (1)" in page
    assert told in json.loads(gradescope(older))["extra_data"]["judged_by"]


def test_a_note_on_the_hand_in_is_on_the_page_and_in_the_table(plain: Result, tmp_path: Path) -> None:
    note = "Cells 1 and 2 begin with %%answer. Cell 2 was judged, because the last one counts."
    one = replace(plain, reason=note)
    assert note in student_page(one, load_exercise(STEM, ROOT), tmp_path)
    assert note in grades_csv([one])
