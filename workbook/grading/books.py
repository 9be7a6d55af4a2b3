"""Everything that is made from results.jsonl: grades.csv, pages, and the forms of other systems."""

import csv
import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path

from workbook.exercise.definition import Exercise
from workbook.grading.exports import canvas, gradescope, moodle, nbgrader
from workbook.grading.files import write_whole
from workbook.grading.gradebook import grades_csv
from workbook.grading.pages import CLASS, PAGES, class_page, page_name, student_page
from workbook.grading.results import Result

GRADES = "grades.csv"
DAY_S = 86_400.0

_SAYS_UTC = re.compile(r" ?(UTC|GMT)$")


class BadOption(ValueError):
    """An option or a file that comes with it cannot be used. The message says why."""


@dataclass(frozen=True)
class Lateness:
    """`share` of the most points is taken off for each day, begun or whole, after `deadline`."""

    deadline: datetime
    share: float

    def unknown(self, results: Iterable[Result]) -> list[Result]:
        """Results of which nobody knows when they were handed in: nothing is taken off."""
        return [
            one for one in results if one["score"] is not None and parse_moment(one["submitted_at"]) is None
        ]

    def taken_off(self, result: Result) -> float:
        """Points that lateness costs this result; 0 when nobody knows when it was handed in."""
        moment = parse_moment(result["submitted_at"])
        if moment is None or result["score"] is None or moment <= self.deadline:
            return 0.0
        days = math.ceil((moment - self.deadline).total_seconds() / DAY_S)
        return float(round(min(result["score"], days * self.share * result["max_score"]), 6))


def parse_moment(text: str | None) -> datetime | None:
    """An ISO 8601 date, in UTC where it names no zone or says so, as nbgrader does; None for what is none."""
    try:
        moment = datetime.fromisoformat(_SAYS_UTC.sub("+00:00", (text or "").strip()))
    except ValueError:
        return None
    return moment if moment.tzinfo is not None else moment.replace(tzinfo=UTC)


def with_lateness(results: Iterable[Result], lateness: Lateness | None) -> list[Result]:
    """The results with lateness taken off; results.jsonl keeps what was earned."""
    if lateness is None:
        return list(results)
    changed = []
    for result in results:
        late = lateness.taken_off(result)
        score = None if result["score"] is None else round(result["score"] - late, 6)
        changed.append({**result, "score": score, "late_points": late})
    return changed


def read_aliases(path: Path) -> dict[str, str]:
    """Who a file or folder belongs to: a CSV with two columns, file or folder name and student. Raises BadOption."""
    aliases: dict[str, str] = {}
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            for number, row in enumerate(csv.reader(file), start=1):
                if not any(cell.strip() for cell in row):
                    continue
                if len(row) < 2 or not row[0].strip() or not row[1].strip():
                    raise BadOption(f"{path}, line {number}: a line is `file or folder,student`")
                name, student = row[0].strip(), row[1].strip()
                if aliases.get(name, student) != student:
                    raise BadOption(f"{path}, line {number}: {name} belongs to two students")
                aliases[name] = student
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise BadOption(f"{path}: {error}") from error
    return aliases


def write_books(
    out: Path,
    exercise: Exercise,
    results: Mapping[tuple[str, str], Result],
    formats: Sequence[str] = (),
    *,
    lateness: Lateness | None = None,
    column: str | None = None,
    assignment: str | None = None,
) -> list[Path]:
    """Write grades.csv and the forms that were asked for below `out`. Returns the files and folders written.

    `column`: what Canvas and Moodle call the exercise. `assignment`: what nbgrader calls it.
    """
    everything = with_lateness(results.values(), lateness)
    mine = [result for result in everything if result["exercise"] == exercise.stem]
    written = [write_whole(out / GRADES, grades_csv(everything))]
    title = column or exercise.source.title
    if "canvas" in formats:
        written.append(write_whole(out / "canvas.csv", canvas(mine, title, exercise.max_points)))
    if "moodle" in formats:
        written.append(write_whole(out / "moodle.csv", moodle(mine, title)))
    if "nbgrader" in formats:
        written.append(write_whole(out / "nbgrader.csv", nbgrader(mine, assignment)))
    if "gradescope" in formats:
        for result in mine:
            name = page_name(result["student"], result["exercise"]).removesuffix(".html")
            write_whole(out / "gradescope" / f"{name}.json", gradescope(result))
        written.append(out / "gradescope")
    if "html" in formats:
        for result in mine:
            name = page_name(result["student"], result["exercise"])
            write_whole(out / PAGES / name, student_page(result, exercise, out))
        written.append(write_whole(out / PAGES / CLASS, class_page(mine, exercise)))
    return written
