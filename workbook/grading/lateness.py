"""What handing in late costs. results.jsonl keeps what was earned; lateness is taken off what is made from it."""

import math
import re
from collections.abc import Iterable
from dataclasses import dataclass, replace
from datetime import UTC, datetime

from workbook.grading.results import Result

DAY_S = 86_400.0

_SAYS_UTC = re.compile(r" ?(UTC|GMT)$")


@dataclass(frozen=True)
class Lateness:
    """`share` of the most points is taken off for each day, begun or whole, after `deadline`."""

    deadline: datetime
    share: float

    def unknown(self, results: Iterable[Result]) -> list[Result]:
        """Results of which nobody knows when they were handed in: nothing is taken off."""
        return [one for one in results if one.score is not None and parse_moment(one.submitted_at) is None]

    def taken_off(self, result: Result) -> float:
        """Points that lateness costs this result; 0 when nobody knows when it was handed in."""
        moment = parse_moment(result.submitted_at)
        if moment is None or result.score is None or moment <= self.deadline:
            return 0.0
        days = math.ceil((moment - self.deadline).total_seconds() / DAY_S)
        return float(round(min(result.score, days * self.share * result.max_score), 6))


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
        score = None if result.score is None else round(result.score - late, 6)
        changed.append(replace(result, score=score, late_points=late))
    return changed
