"""Runs criteria over a recording: passed, failed, partial or skipped. An error of ours is never a student's zero."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from workbook.criteria.criterion import Criterion
from workbook.criteria.verdict import Verdict
from workbook.recording.codec import stored_as
from workbook.recording.plain_text import without_commands
from workbook.recording.recording import Recording

Status = Literal["passed", "failed", "partial", "skipped"]


class CriterionError(RuntimeError):
    """A criterion itself crashed. The answer cannot be judged; the fault is the criterion's."""


@dataclass(frozen=True)
class CriterionResult:
    """One line of a result."""

    id: str
    title: str
    status: Status
    points: float
    max_points: float
    hidden: bool
    saw: str
    expected: str
    because: str
    try_this: str = field(metadata=stored_as("try"))
    about_time: bool = False
    recheck_fields: bool = False
    pace_of: str = ""
    cause: str = ""
    about_end: bool = False


def _skipped(criterion: Criterion, missing: Criterion) -> CriterionResult:
    return CriterionResult(
        id=criterion.id,
        title=criterion.title,
        status="skipped",
        points=0.0,
        max_points=criterion.points,
        hidden=criterion.hidden,
        saw=f"not judged, because this has not passed yet: {missing.title}",
        expected="",
        because="",
        try_this="",
        about_end=criterion.about_end,
    )


def _judged(criterion: Criterion, verdict: Verdict) -> CriterionResult:
    """What a program publishes is in these texts: no terminal and no page may take it for a command."""
    return CriterionResult(
        id=criterion.id,
        title=criterion.title,
        status=verdict.status,
        points=round(criterion.points * verdict.share, 6),
        max_points=criterion.points,
        hidden=criterion.hidden,
        saw=without_commands(verdict.saw),
        expected=without_commands(verdict.expected),
        because=without_commands(verdict.because),
        try_this=without_commands(verdict.try_this),
        about_time=verdict.about_time,
        recheck_fields=verdict.recheck_fields,
        pace_of=verdict.pace_of,
        cause=verdict.cause,
        about_end=criterion.about_end,
    )


def run_criteria(criteria: Sequence[Criterion], recording: Recording) -> tuple[CriterionResult, ...]:
    """Judge a recording. Raises CriterionError when a criterion crashes or returns no verdict."""
    results: dict[str, CriterionResult] = {}
    for criterion in criteria:
        missing = next((need for need in criterion.needs if results[need.id].status != "passed"), None)
        if missing is not None:
            results[criterion.id] = _skipped(criterion, missing)
            continue
        try:
            verdict = criterion(recording)
        except (Exception, SystemExit) as error:
            raise CriterionError(f"the criterion {criterion.id} crashed: {error!r}") from error
        if not isinstance(verdict, Verdict):
            raise CriterionError(f"the criterion {criterion.id} returned {verdict!r} instead of a verdict")
        results[criterion.id] = _judged(criterion, verdict)
    return tuple(results.values())
