"""Change marks after appeals: store the changes in overrides.jsonl, and apply them to all exports.

The changes are imported from a CSV file with these columns:

    student,exercise,criterion,points,reason,who

If `points` is empty, the line undoes an earlier change.
"""

import csv
import json
import math
import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from workbook.grading.changes import Override
from workbook.grading.grades_csv import student_cell
from workbook.grading.results import CriterionLine, Result, StudentAndExercise
from workbook.grading.roster import BadOption
from workbook.recording.codec import decode, encode

OVERRIDES = "overrides.jsonl"
COLUMNS = ("student", "exercise", "criterion", "points", "reason", "who")
TOTAL = "total"
"""The criterion name for a change to the whole score.

An answer that couldn't be judged can get a score in this way, too.
"""
FIX = "Correct the line and run the command again; nothing in this file was applied"


@dataclass(frozen=True)
class OverrideLine:
    """One line of an imported file, which hasn't been matched to a result yet.

    `points` is None if the line undoes an earlier change.
    """

    where: str
    student: str
    exercise: str
    criterion: str
    points: float | None
    reason: str
    who: str


def read_lines(path: Path) -> list[OverrideLine]:
    """Read the lines of a CSV file, skipping a header if there is one.

    Raises BadOption, whose message gives the line's number, if a line is invalid.
    """
    lines: list[OverrideLine] = []
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            reader = csv.reader(file)
            for row in reader:
                cells = [cell.strip() for cell in row[1:]]
                if any(cell.strip() for cell in row) and (*row[:1], *cells) != COLUMNS:
                    lines.append(_line(f"{path}, line {reader.line_num}", row[0], cells))
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise BadOption(f"{path}: {error}") from error
    if not lines:
        raise BadOption(f"{path} holds no change. A line is `{','.join(COLUMNS)}`")
    return lines


def _line(where: str, student: str, cells: Sequence[str]) -> OverrideLine:
    if len(cells) != len(COLUMNS) - 1:
        raise BadOption(
            f"{where}: a line is `{','.join(COLUMNS)}`, but this line has {len(cells) + 1} columns. {FIX}"
        )
    exercise, criterion, text, reason, who = cells
    for column, cell in (("reason", reason), ("who", who)):
        if not cell:
            raise BadOption(
                f"{where}: the column `{column}` is empty: fill it in, because the student will read it. {FIX}"
            )
    try:
        points = float(text) if text else None
    except ValueError:
        points = math.nan
    if points is not None and not (math.isfinite(points) and points >= 0):
        raise BadOption(f"{where}: {text!r} is not a number of points. {FIX}")
    return OverrideLine(where, student, exercise, criterion, points, reason, who)


def fit(lines: Sequence[OverrideLine], results: Mapping[StudentAndExercise, Result]) -> list[Override]:
    """Match the lines to the results, and return the changes to make.

    Raises BadOption for the first line that doesn't match. In that case, none of the lines is applied.
    """
    found: dict[tuple[str, str, str], Override] = {}
    for line in lines:
        change = _fit(line, results)
        if change.key in found:
            raise BadOption(
                f"{line.where}: an earlier line changes the same criterion for the same student. {FIX}"
            )
        found[change.key] = change
    return list(found.values())


def _fit(line: OverrideLine, results: Mapping[StudentAndExercise, Result]) -> Override:
    exercises = {stem for _, stem in results}
    stems = [stem for stem in exercises if line.exercise in (stem, stem.split("_", 1)[-1])]
    if len(stems) != 1:
        there = ", ".join(sorted(exercises)) or "none"
        raise BadOption(f"{line.where}: no results of an exercise {line.exercise}. There are {there}. {FIX}")
    mine = [
        one
        for (_, stem), one in results.items()
        if stem == stems[0] and _is_called(one.student, line.student)
    ]
    if len(mine) != 1:
        raise BadOption(
            f"{line.where}: {line.student!r} has no result in {stems[0]}. Write the name as grades.csv does. {FIX}"
        )
    [result] = mine
    most = _most(result, line.criterion)
    if most is None:
        there = ", ".join([*(one.id for one in result.criteria), TOTAL])
        raise BadOption(f"{line.where}: no criterion {line.criterion!r}. There are {there}. {FIX}")
    if line.points is not None and line.points > most:
        raise BadOption(
            f"{line.where}: {line.points:g} points are more than the {most:g} that it is worth. {FIX}"
        )
    return Override(
        result.student,
        result.exercise,
        line.criterion,
        line.points,
        line.reason,
        line.who,
        result.answer_sha256,
    )


def _is_called(student: str, name: str) -> bool:
    return name == student or name.strip() == student_cell(student)


def _most(result: Result, criterion: str) -> float | None:
    """Return the maximum points for a criterion in this result, or None if the result doesn't have this criterion."""
    if criterion == TOTAL:
        return result.max_score
    return next((one.max_points for one in result.criteria if one.id == criterion), None)


# --- kept -------------------------------------------------------------------------------------------------------------


def keep(out: Path, changes: Iterable[Override]) -> None:
    """Append changes to overrides.jsonl in the folder `out`.

    For each key (`Override.key`), only the last change counts.
    """
    with (out / OVERRIDES).open("a", encoding="utf-8") as file:
        for change in changes:
            file.write(json.dumps(encode(change), allow_nan=False, ensure_ascii=True) + "\n")
        file.flush()
        os.fsync(file.fileno())


def kept(out: Path) -> list[Override]:
    """Return the stored changes, except those that have been undone. Raises BadOption if a line is invalid."""
    path = out / OVERRIDES
    found: dict[tuple[str, str, str], Override] = {}
    if not path.is_file():
        return []
    for number, line in enumerate(path.read_bytes().splitlines(keepends=True), start=1):
        try:
            change = decode(Override, json.loads(line))
        except (ValueError, RecursionError) as error:
            raise BadOption(
                f"{path}, line {number}, holds no change of a mark ({error}): restore it, or delete it"
            ) from error
        found[change.key] = change
    return [one for one in found.values() if one.points is not None]


# --- applied ----------------------------------------------------------------------------------------------------------


def with_changes(results: Iterable[Result], changes: Iterable[Override]) -> list[Result]:
    """Apply the changes, and return the new results.

    A change is applied only if it was made for the current answer and its points don't exceed the criterion's maximum.
    """
    by_key: dict[StudentAndExercise, list[Override]] = {}
    for change in changes:
        by_key.setdefault((change.student, change.exercise), []).append(change)
    changed = []
    for result in results:
        mine = [one for one in by_key.get(result.key, []) if _fits(result, one)]
        for change in sorted(mine, key=lambda one: one.criterion == TOTAL):
            result = _changed(result, change)
        changed.append(result)
    return changed


def without_effect(results: Mapping[StudentAndExercise, Result], changes: Iterable[Override]) -> list[str]:
    """Return a sentence for each stored change that isn't applied, because its answer or criterion has changed."""
    said = []
    for one in changes:
        result = results.get((one.student, one.exercise))
        if result is not None and not _fits(result, one):
            why = (
                "it was made for an earlier answer"
                if result.answer_sha256 != one.answer_sha256
                else ("the criteria have changed")
            )
            said.append(
                f"{one.student}: a change by {one.who} of {one.criterion} is not applied, because {why}. Give the "
                "line again with --override if it still holds"
            )
    return said


def deductions(results: Mapping[StudentAndExercise, Result], changes: Iterable[Override]) -> list[str]:
    """Return a sentence for each change that gives a student fewer points than the judge does.

    This happens if the change raised the points and the criterion was corrected later.
    """
    said = []
    for one in changes:
        result = results.get((one.student, one.exercise))
        if result is None or one.points is None or not _fits(result, one):
            continue
        judged = result.score
        if one.criterion != TOTAL:
            judged = next(line.points for line in result.criteria if line.id == one.criterion)
        if judged is not None and judged > one.points:
            said.append(
                f"{one.student}: the judge gives {judged:g} points for {one.criterion}, and the change by {one.who} "
                f"lowers them to {one.points:g}. To take the change back, give its line with empty points"
            )
    return said


def _fits(result: Result, change: Override) -> bool:
    most = _most(result, change.criterion)
    return (
        result.answer_sha256 == change.answer_sha256
        and change.points is not None
        and most is not None
        and change.points <= most
    )


def _changed(result: Result, change: Override) -> Result:
    assert change.points is not None
    if change.criterion == TOTAL:
        before, title, criteria, score = result.score, "the score", result.criteria, change.points
    else:
        criteria, before, title, score = (), 0.0, "", result.score or 0.0
        for one in result.criteria:
            if one.id == change.criterion:
                before, title = one.points, "a criterion that is not shown" if one.hidden else one.title
                score += change.points - one.points
                one = _line_by_hand(one, change)
            criteria = (*criteria, one)
    by_hand = (*result.by_hand, replace(change, before=before, title=title))
    return replace(
        result, status="graded", reason=None, score=round(score, 6), criteria=criteria, by_hand=by_hand
    )


def _line_by_hand(line: CriterionLine, change: Override) -> CriterionLine:
    assert change.points is not None
    told = f"{change.points:g} of {line.max_points:g} points, given by {change.who}: {change.reason}"
    saw = f"{told} (the judge: {line.points:g} points, {line.saw})"
    if change.points >= line.max_points:
        return replace(
            line, status="passed", points=change.points, saw=saw, expected="", because="", try_this=""
        )
    return replace(line, status="partial" if change.points else "failed", points=change.points, saw=saw)
