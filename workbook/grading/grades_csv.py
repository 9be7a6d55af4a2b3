"""Build grades.csv from the results, using only pure functions."""

import csv
import hashlib
import io
import re
import unicodedata
from collections.abc import Iterable

from workbook.grading.results import Result
from workbook.recording.plain_text import without_commands

_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\u2028\u2029]+")
_MARK = re.compile(r"\[[0-9a-f]{12}\]$")
_FORMULA_STARTS = ("=", "+", "-", "@", "＝", "＋", "－", "＠")
"""The characters that begin a formula. East Asian input methods produce the full-width forms, which count, too."""


def safe_cell(value: object) -> str:
    """Return the content of a table cell that no spreadsheet interprets as a formula.

    An apostrophe is put in front of a leading = + - @. Control characters become spaces, and invisible characters are
    removed.
    """
    if value is None:
        return ""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return f"{value:g}"
    text = without_commands(_CONTROL.sub(" ", str(value))).strip()
    return f"'{text}" if text.startswith(_FORMULA_STARTS) else text


def student_cell(student: str) -> str:
    """Return the content of a table cell for a student's name. Different names never get the same content.

    Most names stay unchanged. If a table or an importer would alter a name, a unique mark is added to it.
    """
    cell = safe_cell(student)
    tame = cell == student and student.isprintable() and "  " not in student and not student.startswith("'")
    return cell if tame and not _MARK.search(student) else _marked(student)


def _marked(student: str) -> str:
    mark = hashlib.sha256(student.encode("utf-8", "surrogatepass")).hexdigest()[:12]
    return f"{safe_cell(student)} [{mark}]".lstrip()


def cells_of(student: str) -> set[str]:
    """Return all strings that may identify a student in a table (see `logins`)."""
    return {student_cell(student), _marked(student)}


def logins(students: Iterable[str]) -> dict[str, str]:
    """Map each student to the content of a cell, for importers that identify students by login.

    Importers may ignore case and different encodings of the same character. If an importer might treat several names as
    the same login, each of these names gets a unique mark. Then the importer finds no student for it, which is better
    than the wrong student.
    """
    by_login: dict[str, set[str]] = {}
    for student in students:
        login = unicodedata.normalize("NFKC", student_cell(student)).casefold()
        by_login.setdefault(login, set()).add(student)
    return {
        one: student_cell(one) if len(alike) == 1 else _marked(one)
        for alike in by_login.values()
        for one in alike
    }


def grades_csv(results: Iterable[Result]) -> str:
    """Return the content of grades.csv: one row for each student and exercise, with columns for the criteria's points.

    If an answer has no score, its cell is empty, not zero.
    """
    rows = sorted(results, key=lambda result: (result.exercise, result.student))
    criteria: list[str] = []
    for result in rows:
        for one in result.criteria:
            if one.max_points > 0 and one.id not in criteria:
                criteria.append(one.id)
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    before = ("student", "exercise", "score", "max_score", "status", "reason")
    writer.writerow([*before, *criteria, "clock", "answer", "tries", "remark"])
    for result in rows:
        earned = {one.id: one.points for one in result.criteria}
        writer.writerow(
            [
                student_cell(result.student),
                result.exercise,
                safe_cell(result.score),
                safe_cell(result.max_score),
                result.status,
                safe_cell(result.reason),
                *(safe_cell(earned.get(name)) for name in criteria),
                safe_cell(result.clock),
                safe_cell(result.answer),
                safe_cell(max(1, len(result.tries))) if result.criteria else "",
                safe_cell(f"{result.tried_twice()} {result.changed_by_hand()}"),
            ]
        )
    return out.getvalue()
