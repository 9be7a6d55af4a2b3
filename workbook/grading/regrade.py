"""Judging again: stored recordings under changed criteria, without running anything, and without ROS."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from workbook.exercise.conclusiveness import EXCUSED_ENDS
from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.grading.new_results import GradedBy, Submission, graded_result
from workbook.grading.results import Result
from workbook.grading.results_file import RESULTS, ResultsFile, last_results
from workbook.grading.retries import counting
from workbook.recording.recording import Recording


@dataclass(frozen=True)
class Regraded:
    """What a change of the criteria did to one student. `problem`: why it could not be judged again."""

    student: str
    before: float | None
    after: float | None
    problem: str = ""

    @property
    def changed(self) -> bool:
        """Whether the score is another one than before; False for what could not be judged again."""
        return not self.problem and self.before != self.after


class CannotRegrade(RuntimeError):
    """A result cannot be judged again. The message says why."""


def regrade(out: Path, exercise: Exercise) -> list[Regraded]:
    """Judge the stored recording of every student again; new results are appended, nothing is run.

    Results that were made under these very criteria are left as they are. Raises FolderInUse.
    """
    with ResultsFile(out / RESULTS) as file:
        known = last_results(out / RESULTS)
        mine = [result for (_, stem), result in sorted(known.items()) if stem == exercise.stem]
        return [_again(out, exercise, result, file) for result in mine if result.status == "graded"]


def _again(out: Path, exercise: Exercise, result: Result, file: ResultsFile) -> Regraded:
    student, before = result.student, result.score
    if result.versions.criteria == exercise.criteria_sha256:
        return Regraded(student, before, before)
    try:
        tries = [
            _judged_again(out / name, doubt, end_only, exercise, result.answer_sha256)
            for name, doubt, end_only in _stored_tries(result)
        ]
    except CannotRegrade as error:
        return Regraded(student, before, None, str(error))
    if not tries:
        return Regraded(student, before, None, "no recording of it was kept")
    if len(tries) == 1 and not tries[0].doubt and any(one.cause in EXCUSED_ENDS for one in tries[0].criteria):
        return Regraded(
            student,
            before,
            None,
            "a bug in rclpy or Python may have changed how it ended; only another run can tell",
        )
    counts = counting(tries)
    if counts.status != "graded":
        return Regraded(student, before, None, counts.reason or "no try counts")
    submission = Submission(
        student, result.answer, result.answer_sha256, result.submitted_at, result.attempt + 1
    )
    file.append(graded_result(submission, tries, GradedBy(exercise, result.isolation, out)))
    return Regraded(student, before, counts.score)


def _stored_tries(result: Result) -> Iterator[tuple[str, str, bool]]:
    """The recordings of all tries, why each was inconclusive, and whether that is about its end alone.

    A try that the slot did not survive has none.
    """
    if not result.tries and result.recording is not None:
        yield result.recording, result.doubt, False
    for one in result.tries:
        if one.recording is not None:
            yield one.recording, one.doubt, one.end_only


def _judged_again(
    path: Path, doubt: str, end_only: bool, exercise: Exercise, answer_sha256: str
) -> Judgement:
    """Raises CannotRegrade."""
    try:
        recording = Recording.load(path)
    except (OSError, ValueError, TypeError) as error:
        raise CannotRegrade(f"its recording cannot be read: {error}") from error
    judgement = judge_recording(exercise, answer_sha256, recording)
    if judgement.status != "graded":
        raise CannotRegrade(judgement.reason or "the criteria failed")
    return judgement if judgement.full_marks else replace(judgement, doubt=doubt, end_only=end_only)
