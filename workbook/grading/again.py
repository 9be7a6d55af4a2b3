"""Judging again: stored recordings under changed criteria, without running anything; and how steady verdicts are."""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from workbook.exercise.definition import Exercise
from workbook.exercise.judging import Judgement, judge_recording
from workbook.grading.pool import Job, Judges
from workbook.grading.results import RESULTS, Result, ResultsFile, graded_result, last_results
from workbook.grading.tries import counting
from workbook.observing.recording import Recording


@dataclass(frozen=True)
class Regraded:
    """What a change of the criteria did to one student. `problem`: why it could not be judged again."""

    student: str
    before: float | None
    after: float | None
    problem: str = ""

    @property
    def changed(self) -> bool:
        return not self.problem and self.before != self.after


def regrade(out: Path, exercise: Exercise) -> list[Regraded]:
    """Judge the stored recording of every student again; new results are appended, nothing is run.

    Results that were made under these very criteria are left as they are. Raises FolderInUse.
    """
    book = ResultsFile(out / RESULTS)
    try:
        known = last_results(out / RESULTS)
        mine = [result for (_, stem), result in sorted(known.items()) if stem == exercise.stem]
        return [_again(out, exercise, result, book) for result in mine if result["status"] == "graded"]
    finally:
        book.close()


def _again(out: Path, exercise: Exercise, result: Result, book: ResultsFile) -> Regraded:
    student, before = result["student"], result["score"]
    if result["versions"]["criteria"] == exercise.criteria_sha256:
        return Regraded(student, before, before)
    tries = []
    for one in result.get("tries") or [result]:
        if one["recording"] is None:
            continue  # a try that the slot did not survive
        try:
            recording = Recording.load(out / one["recording"])
        except (OSError, ValueError, TypeError) as error:
            return Regraded(student, before, None, f"its recording cannot be read: {error}")
        judgement = judge_recording(exercise, result["answer_sha256"], recording)
        if judgement.status != "graded":
            return Regraded(student, before, None, judgement.reason or "the criteria failed")
        tries.append(replace(judgement, doubt=one.get("doubt", "")))
    if not tries:
        return Regraded(student, before, None, "no recording of it was kept")
    book.append(
        graded_result(
            out,
            counting(tries),
            student=student,
            answer=result["answer"],
            submitted_at=result["submitted_at"],
            attempt=result["attempt"] + 1,
            isolation=result["isolation"],
            criteria_sha256=exercise.criteria_sha256,
            max_score=exercise.max_points,
            tries=tries,
        )
    )
    return Regraded(student, before, counting(tries).score)


@dataclass(frozen=True)
class Unsteady:
    """An answer whose verdict changes from run to run: each verdict, and how often it came."""

    student: str
    verdicts: tuple[tuple[str, int], ...]


def verdict_of(judgement: Judgement) -> str:
    """Points and what was lost, as one line."""
    if judgement.status != "graded":
        return f"not judged: {judgement.reason}"
    lost = [one.id for one in judgement.criteria if one.status in ("failed", "partial")]
    return f"{judgement.score:g} points" + (f" (lost: {', '.join(lost)})" if lost else "")


def unsteady(jobs: Sequence[Job[str]], times: int, judges: Judges) -> Iterator[Unsteady]:
    """Judge every answer `times` times; yields those that did not get the same verdict each time."""
    many = [Job(job.key, job.stem, job.answer) for job in jobs for _ in range(times)]
    found: dict[str, Counter[str]] = {}
    for job, judgement in judges.judge_all(many):
        found.setdefault(job.key, Counter())[verdict_of(judgement)] += 1
    for student, verdicts in sorted(found.items()):
        if len(verdicts) > 1:
            yield Unsteady(student, tuple(verdicts.most_common()))
