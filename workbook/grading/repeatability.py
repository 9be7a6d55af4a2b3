"""Measure how repeatable verdicts are, by judging the same answers many times."""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

from workbook.exercise.judgement import Judgement
from workbook.grading.judges import GradingBackend, Job


@dataclass(frozen=True)
class Unsteady:
    """An answer whose verdict varies. `verdicts`: each verdict with the number of times that it occurred."""

    student: str
    verdicts: tuple[tuple[str, int], ...]


def verdict_of(judgement: Judgement) -> str:
    """Summarize the points and the failed criteria in one line."""
    if judgement.status != "graded":
        return f"not judged: {judgement.reason}"
    lost = [one.id for one in judgement.criteria if one.status in ("failed", "partial")]
    return f"{judgement.score:g} points" + (f" (lost: {', '.join(lost)})" if lost else "")


def unsteady(jobs: Sequence[Job[str]], times: int, judges: GradingBackend) -> Iterator[Unsteady]:
    """Judge every answer `times` times. Yield the answers that got different verdicts."""
    many = [replace(job) for job in jobs for _ in range(times)]
    found: dict[str, Counter[str]] = {}
    for job, judgement in judges.judge_all(many):
        found.setdefault(job.key, Counter())[verdict_of(judgement)] += 1
    for student, verdicts in sorted(found.items()):
        if len(verdicts) > 1:
            yield Unsteady(student, tuple(verdicts.most_common()))
