"""Compute late penalties. results.jsonl stores the points as earned, and only the exports subtract the penalty."""

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from datetime import UTC, datetime

from workbook.grading.deadlines import same_name
from workbook.grading.results import Result

DAY_S = 86_400.0

_SAYS_UTC = re.compile(r" ?(UTC|GMT)$")


@dataclass(frozen=True)
class Lateness:
    """A late penalty: the fraction `share` of the maximum score for each day after `deadline`, complete or not.

    `extensions`: later deadlines for individual students, keyed by their names as `same_name` returns them.
    """

    deadline: datetime
    share: float
    extensions: Mapping[str, datetime] = field(default_factory=dict)

    def deadline_of(self, student: str) -> datetime:
        """Return this student's deadline."""
        return self.extensions.get(same_name(student), self.deadline)

    def unknown(self, results: Iterable[Result]) -> list[Result]:
        """Return the results whose submission time is unknown. They don't get a penalty."""
        return [one for one in results if one.score is not None and parse_moment(one.submitted_at) is None]

    def taken_off(self, result: Result) -> float:
        """Return a result's late penalty in points, which is 0 if the submission time is unknown."""
        moment = parse_moment(result.submitted_at)
        deadline = self.deadline_of(result.student)
        if moment is None or result.score is None or moment <= deadline:
            return 0.0
        days = math.ceil((moment - deadline).total_seconds() / DAY_S)
        return float(round(min(result.score, days * self.share * result.max_score), 6))


def parse_moment(text: str | None) -> datetime | None:
    """Parse an ISO 8601 time, or return None if it's invalid. A time without a time zone is in UTC, as in nbgrader."""
    try:
        moment = datetime.fromisoformat(_SAYS_UTC.sub("+00:00", (text or "").strip()))
    except ValueError:
        return None
    return moment if moment.tzinfo is not None else moment.replace(tzinfo=UTC)


def with_lateness(results: Iterable[Result], lateness: Lateness | None) -> list[Result]:
    """Subtract the late penalty from the results' scores. Return the new results."""
    if lateness is None:
        return list(results)
    changed = []
    for result in results:
        late = lateness.taken_off(result)
        score = None if result.score is None else round(result.score - late, 6)
        changed.append(replace(result, score=score, late_points=late))
    return changed
