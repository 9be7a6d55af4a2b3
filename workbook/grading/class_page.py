"""Render a page about the class: marks, common failures and their causes, and a map with links to the students' pages.

The map is a table with a row for each student and a column for each criterion. The page is a single file. Its content
security policy allows only one script, which sorts and filters the map.
"""

import base64
import hashlib
import json
import re
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

from workbook.exercise.definition import Exercise
from workbook.feedback.colors import COLORS, tint
from workbook.feedback.wording import SIGNS, WORDS
from workbook.grading.exports import by_student
from workbook.grading.pages import TEXT_COLORS, page_name
from workbook.grading.results import CriterionLine, Result
from workbook.templating import as_markup, render

SLOWEST = 5
CAUSES = 8
SIGHTS = 3
MOST_STUDENTS = 3000
"""The maximum number of students on the map. With more cells, browsers would be slow."""
GROUNDS = {
    "passed": tint("passed"),
    "partial": tint("partial", 0.4),
    "failed": tint("failed", 0.45),
    "skipped": tint("skipped", 0.25),
}
_SCRIPT = Path(__file__).parent / "templates" / "class.js"
_FIGURE = Path(__file__).parents[1] / "lab" / "front_end" / "panel" / "figure.json"
"""The robot's shapes as data. Drawing them with Matplotlib would slow grading down, because importing it takes time."""
_NUMBER = re.compile(r"\d+(\.\d+)?")


def class_page(results: Iterable[Result], exercise: Exercise) -> str:
    """Render the class page: points, common failures, the map of all students, and answers to check by hand."""
    rows = by_student(results)
    graded = [row for row in rows if row.score is not None]
    shown = sorted(rows, key=lambda row: (row.score is None, row.score or 0.0, row.student))[:MOST_STUDENTS]
    criteria = _columns(graded)
    causes = _causes(graded, criteria)
    script = _script()
    return render(
        "grading/class",
        title=f"{exercise.source.title}: the class",
        text_colors=TEXT_COLORS,
        colors=COLORS,
        grounds=GROUNDS,
        signs=SIGNS,
        words=WORDS,
        page_name=page_name,
        rows=rows,
        graded=graded,
        shown=shown,
        left_out=len(rows) - len(shown),
        head=_head(),
        figures=_figures(rows, graded),
        isolation=_isolation(rows),
        judged_by=_judged_by(rows),
        distribution=_distribution(graded, round(exercise.max_points)),
        criteria=criteria,
        causes=causes,
        most_causes=CAUSES,
        causes_of=_causes_of(causes),
        lines={row.student: _lines(row, criteria) for row in shown},
        has_timelines=bool(exercise.periods),
        slowest=_slowest(graded),
        twice=sorted((row for row in rows if row.tries), key=lambda row: row.tries_differ, reverse=True),
        missing=[row for row in rows if row.score is None],
        script=as_markup(script),
        script_sha256=base64.b64encode(hashlib.sha256(script.encode()).digest()).decode(),
    )


@cache
def _script() -> str:
    return _SCRIPT.read_text(encoding="utf-8")


@cache
def _head() -> list[dict[str, Any]]:
    """Return the shapes that make up the robot's head in its operational state."""
    parts = json.loads(_FIGURE.read_text(encoding="utf-8"))["parts"]
    shown = (
        one for one in parts if "neck" in one["joints"] and "operational" in one.get("faces", ["operational"])
    )
    return [shape for part in shown for shape in part["shapes"]]


def _figures(rows: Sequence[Result], graded: Sequence[Result]) -> list[tuple[str, str]]:
    """Return the class's key figures as (label, value) pairs."""
    figures = [("answer" if len(rows) == 1 else "answers", str(len(rows))), ("graded", str(len(graded)))]
    scores = sorted(row.score for row in graded if row.score is not None)
    if scores:
        middle = (scores[(len(scores) - 1) // 2] + scores[len(scores) // 2]) / 2
        full = sum(row.score is not None and row.score >= row.max_score for row in graded)
        mean = f"{sum(scores) / len(scores):.2g}"
        figures += [("mean, points", mean), ("median, points", f"{middle:g}"), ("full marks", str(full))]
    return figures


def _isolation(rows: Sequence[Result]) -> str:
    tiers = Counter(row.isolation for row in rows)
    told = ", ".join(f"{tier} ({count})" for tier, count in sorted(tiers.items()))
    problems = Counter(row.isolation_problem for row in rows if row.isolation_problem)
    missing = "".join(f" Of {count} programs: {problem}" for problem, count in problems.most_common())
    return f"Isolation: {told}.{missing}" if told else ""


def _judged_by(rows: Sequence[Result]) -> str:
    """Return a sentence about the versions that judged the answers, with counts if there are several."""
    versions = Counter(row.versions.description() for row in rows).most_common()
    if len(versions) < 2:
        return "".join(f"Judged by {one}." for one, _ in versions)
    return f"Judged by {'; '.join(f'{one} ({count})' for one, count in versions)}."


def _distribution(graded: Sequence[Result], most: int) -> list[tuple[int, int, float]]:
    """Return the histogram's bars as (points, count, height). Points are rounded down.

    A bar's height is its count divided by the largest count.
    """
    bins = Counter(min(most, int(row.score)) for row in graded if row.score is not None)
    largest = max(bins.values(), default=1)
    return [(points, bins[points], bins[points] / largest) for points in range(most + 1)]


@dataclass(frozen=True)
class _Column:
    """A criterion's column on the map.

    `lost`: the number of answers that failed it completely or in part. `skipped`: the number of answers for which it
    wasn't judged.
    """

    column: int
    id: str
    title: str
    hidden: bool
    lost: int
    skipped: int

    @property
    def matters(self) -> bool:
        """Whether at least one student didn't pass this criterion."""
        return bool(self.lost or self.skipped)


def _columns(graded: Sequence[Result]) -> list[_Column]:
    """Return a column for each criterion, in the exercise's order.

    A criterion without points gets a column only if a student failed it.
    """
    lines: dict[str, list[CriterionLine]] = defaultdict(list)
    for row in graded:
        for one in row.criteria:
            lines[one.id].append(one)
    kept = [some for some in lines.values() if any(one.max_points or one.is_lost for one in some)]
    return [
        _Column(
            column,
            some[0].id,
            some[0].title,
            some[0].hidden,
            sum(one.is_lost for one in some),
            sum(one.status == "skipped" for one in some),
        )
        for column, some in enumerate(kept, start=1)
    ]


def _lines(row: Result, criteria: Sequence[_Column]) -> list[CriterionLine | None]:
    """Return a student's results, one for each column, or None for a criterion that isn't in the student's result."""
    found = {one.id: one for one in row.criteria}
    return [found.get(one.id) for one in criteria]


@dataclass(frozen=True)
class _Cause:
    """A cause of lost points: its explanation in the feedback, and the judge's observations.

    `sights`: the most frequent observations, each with its count. `other_sights`: the count of all other observations.
    `who`: the students.
    """

    number: int
    column: int
    title: str
    because: str
    sights: tuple[tuple[str, int], ...]
    other_sights: int
    who: frozenset[str]

    @property
    def students(self) -> int:
        return len(self.who)


def _causes(graded: Sequence[Result], criteria: Sequence[_Column]) -> list[_Cause]:
    """Group the failed criteria by cause, and return the causes, most frequent first.

    Two failures have the same cause if they have the same criterion and their explanations differ at most in numbers.
    """
    found: dict[tuple[str, str], list[tuple[str, CriterionLine]]] = defaultdict(list)
    for row in graded:
        for one in row.criteria:
            if one.is_lost:
                found[one.id, _NUMBER.sub("0", one.because or one.saw)].append((row.student, one))
    column_of = {one.id: one for one in criteria}
    ordered = sorted(found.items(), key=lambda item: (-len(item[1]), column_of[item[0][0]].column))
    causes = []
    for number, ((criterion, _), lost) in enumerate(ordered):
        sights = Counter(one.saw for _, one in lost).most_common()
        told = Counter(one.because for _, one in lost).most_common(1)[0][0]
        column = column_of[criterion]
        causes.append(
            _Cause(
                number,
                column.column,
                column.title,
                told,
                tuple(sights[:SIGHTS]),
                sum(count for _, count in sights[SIGHTS:]),
                frozenset(student for student, _ in lost),
            )
        )
    return causes


def _causes_of(causes: Sequence[_Cause]) -> Mapping[str, list[int]]:
    """Map each student to the numbers of the causes for which the student lost points."""
    numbers: dict[str, list[int]] = defaultdict(list)
    for cause in causes:
        for student in cause.who:
            numbers[student].append(cause.number)
    return numbers


def _slowest(graded: Sequence[Result]) -> list[Result]:
    return sorted((row for row in graded if row.wall_s is not None), key=lambda row: -(row.wall_s or 0.0))[
        :SLOWEST
    ]
