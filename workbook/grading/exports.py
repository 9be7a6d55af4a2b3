"""Export the gradebook to other systems' formats, using only pure functions of results.

The formats are Gradescope's results.json (docs/specs.md in its autograder samples) and Canvas's gradebook CSV
(gradebook_importer.rb). There are also Moodle's grade import (a CSV keyed by ID number) and nbgrader's export
(plugins/export.py).
"""

import csv
import io
import json
from collections.abc import Iterable, Sequence
from typing import Any

from markupsafe import escape

from workbook.grading.grades_csv import logins, safe_cell, student_cell
from workbook.grading.lateness import parse_moment
from workbook.grading.results import Result
from workbook.recording.plain_text import without_commands

FORMATS = ("csv", "html", "gradescope", "canvas", "moodle", "nbgrader")


def by_student(results: Iterable[Result]) -> list[Result]:
    """Sort results by exercise and student."""
    return sorted(results, key=lambda result: (result.exercise, result.student))


def _rows(rows: Sequence[Sequence[object]]) -> str:
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows(rows)
    return out.getvalue()


def _said(result: Result) -> str:
    """Summarize a result's feedback in a few sentences of plain text, without hidden criteria.

    Changes that a person made come first.
    """
    return without_commands(f"{result.changed_by_hand()} {_judged(result)}".strip())


def _judged(result: Result) -> str:
    if result.status != "graded":
        return f"Not graded: {result.reason}"
    first = next(
        (one for one in result.criteria if one.is_lost and not one.hidden),
        None,
    )
    if first is None:
        return "Every criterion that you can see is met." if result.criteria else ""
    return f"{first.title}: seen {first.saw}; expected {first.expected}. {first.because} {first.try_this}"


def gradescope(result: Result) -> str:
    """Return the content of Gradescope's results.json for one submission.

    An answer that couldn't be graded gets no score. Then Gradescope reports that the autograder failed to run, instead
    of counting the answer as zero.
    """
    tests: list[dict[str, Any]] = []
    for number, one in enumerate(result.criteria, start=1):
        if one.max_points == 0 and one.status == "passed":
            continue
        tests.append(
            {
                "name": one.title,
                "name_format": "text",
                "number": str(number),
                "score": one.points,
                "max_score": one.max_points,
                "status": "passed" if one.status == "passed" else "failed",
                "output": "\n".join(one.feedback()),
                "output_format": "text",
                "visibility": "hidden" if one.hidden else "visible",
            }
        )
    data: dict[str, Any] = {
        "output": f"{result.exercise}: {_said(result)}",
        "output_format": "text",
        "test_output_format": "text",
        "test_name_format": "text",
        "stdout_visibility": "hidden",
        "extra_data": {
            "status": result.status,
            "clock": result.clock,
            "isolation": result.isolation,
            "judged_by": result.versions.description(),
        },
        "tests": tests,
    }
    if result.score is not None:
        data["score"] = result.score
    if result.wall_s is not None:
        data["execution_time"] = round(result.wall_s)
    return json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False) + "\n"


def canvas(results: Iterable[Result], assignment: str, points: float) -> str:
    """Return a CSV table to import into Canvas.

    `assignment`: the exercise's column in Canvas, such as "Exercise 09 (12345)".

    Canvas identifies students by login. For a result without a score, the cell is empty, and Canvas ignores it.
    """
    head: list[object] = ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", assignment]
    rows: list[list[object]] = [head, ["    Points Possible", "", "", "", "", f"{points:g}"]]
    mine = by_student(results)
    login = logins(result.student for result in mine)
    for result in mine:
        student = login[result.student]
        rows.append([student, "", "", student, "", safe_cell(result.score)])
    return _rows(rows)


def moodle(results: Iterable[Result], item: str) -> str:
    """Return a CSV table for Moodle's grade import.

    In Moodle's import form, map "ID number" to the students and the column `item` to the grade.

    Moodle shows feedback as HTML, so characters with a special meaning in HTML are escaped. Results without a score are
    left out, because an empty grade would delete an earlier one.
    """
    rows: list[list[object]] = [["ID number", item, f"{item} (feedback)"]]
    mine = by_student(results)
    login = logins(result.student for result in mine)
    for result in mine:
        if result.score is not None:
            feedback = str(escape(safe_cell(_said(result))))
            rows.append([login[result.student], safe_cell(result.score), feedback])
    return _rows(rows)


NBGRADER = (
    "assignment", "duedate", "timestamp", "student_id", "last_name", "first_name", "email", "raw_score",
    "late_submission_penalty", "score", "max_score",
)  # fmt: skip


def nbgrader(results: Iterable[Result], assignment: str | None = None) -> str:
    """Return a CSV table with the same columns as nbgrader's own export.

    `assignment`: the exercise's name in nbgrader, or None if it's the same there.
    """
    rows: list[Sequence[object]] = [NBGRADER]
    for result in by_student(results):
        raw = None if result.score is None else round(result.score + result.late_points, 6)
        rows.append(
            [
                safe_cell(assignment or result.exercise),
                "",
                safe_cell(result.submitted_at if parse_moment(result.submitted_at) else None),
                student_cell(result.student),
                "",
                "",
                "",
                safe_cell(raw),
                safe_cell(result.late_points),
                safe_cell(result.score),
                safe_cell(result.max_score),
            ]
        )
    return _rows(rows)
