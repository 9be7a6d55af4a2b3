"""Run criteria on a recording. If a criterion crashes, there is no score, so our bugs never cost a student points."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Literal

from workbook.criteria.budget import BUDGET_S, OutOfTime, within_budget
from workbook.criteria.criterion import Criterion
from workbook.criteria.verdict import Verdict
from workbook.recording.codec import stored_as
from workbook.recording.plain_text import without_commands
from workbook.recording.recording import Recording

Status = Literal["passed", "failed", "partial", "skipped"]


class CriterionError(RuntimeError):
    """Raised when an answer can't be judged because a criterion crashed, took too long, or didn't return a verdict."""


@dataclass(frozen=True)
class CriterionResult:
    """The result of one criterion."""

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
    """Return a criterion's result, with its strings sanitized.

    They may quote the program's output, which a terminal or a page must not interpret as commands.
    """
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


def run_criteria(
    criteria: Sequence[Criterion], recording: Recording, budget_s: float = BUDGET_S
) -> tuple[CriterionResult, ...]:
    """Judge a recording, with `budget_s` seconds of CPU time for all criteria together.

    Raises CriterionError if a criterion crashes, doesn't return a verdict, or exhausts the budget.
    """
    results: dict[str, CriterionResult] = {}
    at_work = ""

    def judge_all() -> None:
        nonlocal at_work
        for criterion in criteria:
            at_work = criterion.id
            missing = next((need for need in criterion.needs if results[need.id].status != "passed"), None)
            if missing is None:
                results[criterion.id] = _judged(criterion, _verdict(criterion, recording))
            else:
                results[criterion.id] = _skipped(criterion, missing)

    try:
        within_budget(judge_all, budget_s)
    except OutOfTime as error:
        told = f"the criterion {at_work} ran out of time: all criteria together have {budget_s:g} s for a recording"
        raise CriterionError(told) from error
    return tuple(results.values())


def _verdict(criterion: Criterion, recording: Recording) -> Verdict:
    """Return a criterion's verdict. Raises CriterionError if the criterion crashes or returns anything else."""
    try:
        verdict = criterion(recording)
    except (Exception, SystemExit) as error:
        raise CriterionError(f"the criterion {criterion.id} crashed: {error!r}") from error
    if not isinstance(verdict, Verdict):
        raise CriterionError(f"the criterion {criterion.id} returned {verdict!r} instead of a verdict")
    return verdict
