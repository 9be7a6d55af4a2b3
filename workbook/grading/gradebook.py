"""grades.csv: a pure function of the results."""

import csv
import io
import re
from collections.abc import Iterable

from workbook.grading.results import Result, tried_twice

_CONTROL = re.compile(r"[\x00-\x1f\x7f-\x9f\u2028\u2029]+")
_FORMULA_STARTS = ("=", "+", "-", "@")


def safe_cell(value: object) -> str:
    """Text that no spreadsheet takes for a formula: a leading = + - @ gets an apostrophe, control bytes go."""
    if value is None:
        return ""
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return f"{value:g}"
    text = _CONTROL.sub(" ", str(value)).strip()
    return f"'{text}" if text.startswith(_FORMULA_STARTS) else text


def grades_csv(results: Iterable[Result]) -> str:
    """One row per student and exercise, a column of points per criterion.

    An answer without a score has an empty cell, never a zero.
    """
    rows = sorted(results, key=lambda result: (result["exercise"], result["student"]))
    criteria: list[str] = []
    for result in rows:
        for one in result["criteria"]:
            if one["max_points"] > 0 and one["id"] not in criteria:
                criteria.append(one["id"])
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    before = ("student", "exercise", "score", "max_score", "status", "reason")
    writer.writerow([*before, *criteria, "clock", "answer", "tries", "remark"])
    for result in rows:
        earned = {one["id"]: one["points"] for one in result["criteria"]}
        writer.writerow(
            [
                safe_cell(result["student"]),
                result["exercise"],
                safe_cell(result["score"]),
                safe_cell(result["max_score"]),
                result["status"],
                safe_cell(result["reason"]),
                *(safe_cell(earned.get(name)) for name in criteria),
                safe_cell(result["clock"]),
                safe_cell(result["answer"]),
                safe_cell(max(1, len(result.get("tries") or []))) if result["criteria"] else "",
                safe_cell(tried_twice(result)),
            ]
        )
    return out.getvalue()
