"""A class's page: the most frequent failures, their causes, and a table that links to every student's page."""

import base64
import hashlib
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import pytest

from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import judge_recording
from workbook.grading import class_page as module
from workbook.grading.class_page import class_page
from workbook.grading.new_results import GradedBy, Submission, graded_result, ungradable_result
from workbook.grading.pages import page_name, student_page
from workbook.grading.results import Result
from workbook.recording.recording import Recording

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
EXERCISE = load_exercise(STEM, ROOT)


def result(out: Path, student: str, recording: str = "solution") -> Result:
    stored = Recording.load(ROOT / "tests" / "recordings" / STEM / f"{recording}.json")
    judgement = judge_recording(EXERCISE, "a" * 64, stored)
    return graded_result(
        Submission(student, f"{student}.py", "a" * 64), [judgement], GradedBy(EXERCISE, "sandbox", out)
    )


def refused(student: str) -> Result:
    by = GradedBy(EXERCISE, "sandbox", Path())
    return ungradable_result(Submission(student, "x.py", ""), "the file is empty", by)


class Page(HTMLParser):
    """The tags of a page, and the texts of its table cells, row by row."""

    def __init__(self, html: str) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str]]] = []
        self.rows: list[list[str]] = []
        self._in_cell = False
        self.feed(html)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, {name: value or "" for name, value in attrs}))
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self._in_cell = True
            self.rows[-1].append("")

    def handle_endtag(self, tag: str) -> None:
        if tag in ("td", "th"):
            self._in_cell = False

    def handle_data(self, data: str) -> None:
        if self._in_cell:
            self.rows[-1][-1] += data

    def row_of(self, first: str) -> list[str]:
        return next(row for row in self.rows if row and row[0].strip() == first)


@pytest.fixture
def few(tmp_path: Path) -> list[Result]:
    return [
        result(tmp_path, "ada"),
        result(tmp_path, "bob", "eleven_values"),
        result(tmp_path, "eve", "eleven_values"),
        result(tmp_path, "joe", "period_for_frequency"),
        result(tmp_path, "kim", "wrong_name"),
        refused("mallory"),
    ]


def test_everybody_has_a_row_the_fewest_points_first(few: list[Result]) -> None:
    page = Page(class_page(few, EXERCISE))
    students = [row[0].strip() for row in page.rows if row and row[0].strip() in {one.student for one in few}]
    assert students[:6] == ["kim", "joe", "bob", "eve", "ada", "mallory"]
    assert page.row_of("kim")[1:4] == ["3", "✗ not yet", "– not judged"]
    assert page.row_of("mallory")[1:4] == ["–", "", ""]


def test_each_cell_leads_to_its_line_on_the_students_page(few: list[Result], tmp_path: Path) -> None:
    links = [attrs["href"] for tag, attrs in Page(class_page(few, EXERCISE)).tags if tag == "a"]
    for one in few:
        name = page_name(one.student, STEM)
        ids = {attrs.get("id") for _, attrs in Page(student_page(one, EXERCISE, tmp_path)).tags}
        mine = {link.partition("#")[2] for link in links if link.startswith(f"{name}#")}
        assert mine <= ids
        if one.criteria:
            assert mine == {"timeline", *(f"criterion-{line.id}" for line in one.criteria if line.max_points)}


def test_a_hidden_criterion_has_a_column_and_no_line_to_lead_to(few: list[Result], tmp_path: Path) -> None:
    hidden = [
        replace(
            one, criteria=tuple(replace(line, hidden=line.id == "twelve_values") for line in one.criteria)
        )
        for one in few
    ]
    html = class_page(hidden, EXERCISE)
    assert "Every message has exactly 12 values</a> (hidden)" in html
    assert "#criterion-twelve_values" not in html
    assert "twelve_values" not in student_page(hidden[1], EXERCISE, tmp_path)


def test_causes_are_counted_by_their_reason_and_say_what_was_seen(few: list[Result], tmp_path: Path) -> None:
    """Differences in measured numbers alone don't make a separate cause."""
    lost = next(line for line in few[1].criteria if line.is_lost)
    other = replace(lost, saw="every message has 13 values", because=lost.because.replace("0", "2"))
    criteria = tuple(other if line.id == lost.id else line for line in few[1].criteria)
    page = Page(class_page([*few, replace(few[1], student="lea", criteria=criteria)], EXERCISE))
    [cause] = [row for row in page.rows if len(row) == 4 and lost.because in row[2]]
    assert cause[0].startswith("3 students")
    assert cause[3] == "2 × every message has 11 values1 × every message has 13 values"
    counts = [int(row[0].split()[0]) for row in page.rows if row and ": show them" in row[0]]
    assert counts == sorted(counts, reverse=True)
    assert len(counts) == 3


def test_the_one_script_is_the_one_that_the_page_allows(few: list[Result]) -> None:
    odd = [
        replace(few[1], student="</script><script>alert(1)</script>"),
        refused('"><img src=x onerror=alert(1)>'),
    ]
    html = class_page([*few, *odd], EXERCISE)
    scripts = re.findall(r"<script[^>]*>(.*?)</script>", html, re.DOTALL)
    assert len(scripts) == 1
    digest = base64.b64encode(hashlib.sha256(scripts[0].encode()).digest()).decode()
    policy = next(attrs["content"] for tag, attrs in Page(html).tags if attrs.get("http-equiv"))
    assert f"script-src 'sha256-{digest}'" in policy
    assert "default-src 'none'" in policy and "unsafe-inline" not in policy.partition("script-src")[2]
    page = Page(html)
    assert not {tag for tag, _ in page.tags} & {"img", "link", "iframe"}
    assert not [name for _, attrs in page.tags for name in attrs if name == "src" or name.startswith("on")]
    assert not [attrs for tag, attrs in page.tags if tag == "a" and ":" in attrs["href"]]


def test_a_huge_class_shows_those_with_the_fewest_points(
    few: list[Result], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "MOST_STUDENTS", 2)
    html = class_page(few, EXERCISE)
    assert "The 2 with the fewest points are shown" in html
    assert html.count('<th scope="row"') == 2


def test_a_class_of_nobody_and_one_without_marks_have_a_page() -> None:
    for some, answers in (([], "answers</dt><dd>0"), ([refused("bob")], "answer</dt><dd>1")):
        page = class_page(some, EXERCISE)
        assert f"<dt>{answers}</dd>" in page and "<dt>graded</dt><dd>0</dd>" in page
        assert "No answer was graded." in page and "median" not in page


def test_what_nobody_has_takes_no_room(few: list[Result], tmp_path: Path) -> None:
    page = Page(class_page(few, EXERCISE))
    [histogram] = [attrs for _, attrs in page.tags if attrs.get("class") == "histogram"]
    assert histogram["aria-label"].endswith(": 1 with 3, 1 with 8, 2 with 9, 1 with 10")
    counted = [row for row in page.rows if len(row) == 3 and row[0][:1].isdigit()]
    assert counted and all(row[1:] != ["0", "0"] for row in counted)
    best = class_page([result(tmp_path, "ada")], EXERCISE)
    assert "All students passed all 8." in best and '<th scope="col">not yet</th>' not in best
