"""Judge stored recordings again after the criteria have changed, without running programs and without ROS."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from workbook.exercise.definition import Exercise
from workbook.exercise.inconclusive import EXCUSED_ENDS, script_cut_short
from workbook.exercise.judgement import Judgement, judge_recording, kept_from_simulated_time
from workbook.exercise.retries import counting
from workbook.grading.new_results import GradedBy, Submission, graded_result, versions
from workbook.grading.results import CriterionLine, Result
from workbook.grading.results_file import RESULTS, ResultsFile, last_results
from workbook.recording.recording import Recording

NO_SCORE = "it has no score, because no try of it counted. Run `workbook grade` on the answers again"
NO_RECORDING = "no recording of it was kept. Run `workbook grade` on the answers again"


@dataclass(frozen=True)
class CriterionChange:
    """A criterion's points before and after regrading. None means that the result doesn't have this criterion."""

    id: str
    before: float | None
    after: float | None


@dataclass(frozen=True)
class Regraded:
    """The effect of judging one student's recordings again.

    `problem`: why the recordings couldn't be judged again, or "" if they could. `criteria`: the criteria whose points
    changed, including criteria that were added or removed.
    """

    student: str
    before: float | None
    after: float | None
    problem: str = ""
    criteria: tuple[CriterionChange, ...] = ()

    @property
    def changed(self) -> bool:
        """Whether any points changed. It's False if the recordings couldn't be judged again."""
        return not self.problem and (self.before != self.after or bool(self.criteria))


def criterion_changes(
    before: tuple[CriterionLine, ...], after: tuple[CriterionLine, ...]
) -> tuple[CriterionChange, ...]:
    """Return the criteria whose points differ, in the order of `after`. A missing criterion counts as 0 points."""
    old, new = _points(before), _points(after)
    return tuple(
        CriterionChange(name, old.get(name), new.get(name))
        for name in dict.fromkeys([*new, *old])
        if old.get(name, 0.0) != new.get(name, 0.0)
    )


def _points(lines: tuple[CriterionLine, ...]) -> Mapping[str, float]:
    return {one.id: one.points for one in lines}


class CannotRegrade(RuntimeError):
    """Raised when a result can't be judged again. The message says why."""


def regrade(out: Path, exercise: Exercise) -> list[Regraded]:
    """Judge every student's stored recordings again, without running programs, and append the new results.

    A new result isn't appended if it's the same as before and the earlier result was made with exactly these criteria.
    A result without a score because a criterion crashed is judged again, too. Raises FolderInUse if another run is
    using the folder.
    """
    with ResultsFile(out / RESULTS) as file:
        known = last_results(out / RESULTS)
        mine = [result for (_, stem), result in sorted(known.items()) if stem == exercise.stem]
        return [_again(out, exercise, result, file) for result in mine if result.status != "ungradable"]


def _again(out: Path, exercise: Exercise, result: Result, file: ResultsFile) -> Regraded:
    """Judge a result's recordings again, even if the criteria are unchanged.

    A judgment also depends on other parts of the course, which may have changed.
    """
    if result.status != "graded" and result.tries:  # no try counted, and judging again can't change that
        return Regraded(result.student, result.score, None, NO_SCORE)
    found = _new_result(out, exercise, result)
    is_ours = result.status == "graded" and _made_by(result) == _made_by(result, exercise.criteria_sha256)
    if isinstance(found, str):
        return Regraded(
            result.student, result.score, result.score if is_ours else None, "" if is_ours else found
        )
    changes = criterion_changes(result.criteria, found.criteria)
    if changes or result.score != found.score or not is_ours:
        file.append(found)
    return Regraded(result.student, result.score, found.score, criteria=changes)


def _made_by(result: Result, criteria: str = "") -> tuple[str, str]:
    """Return the workbook version and the criteria's hash with which a result was made.

    If `criteria` is given, return the current workbook version and `criteria` instead.
    """
    made = versions(criteria) if criteria else result.versions
    return made.workbook, made.criteria


def _new_result(out: Path, exercise: Exercise, result: Result) -> Result | str:
    """Return the new result, or the reason why there is none."""
    try:
        tries = [
            _judged_again(out / name, inconclusive_reason, end_only, exercise, result.answer_sha256)
            for name, inconclusive_reason, end_only in _stored_tries(result)
        ]
    except CannotRegrade as error:
        return str(error)
    if not tries:
        return NO_RECORDING
    if (
        len(tries) == 1
        and not tries[0].inconclusive_reason
        and any(one.cause in EXCUSED_ENDS for one in tries[0].criteria)
    ):
        return "a bug in rclpy or Python may have changed how it ended; only another run can tell"
    counts = counting(tries)
    if counts.status != "graded":
        return counts.reason or "no try counts"
    submission = Submission(
        result.student,
        result.answer,
        result.answer_sha256,
        result.submitted_at,
        result.attempt + 1,
        result.reason or "" if result.status == "graded" else "",
    )
    new = graded_result(submission, tries, GradedBy(exercise, result.isolation, out))
    # the program ran with the earlier rclpy and Python, whatever versions judge its recording now
    ran = result.versions
    return replace(new, versions=replace(new.versions, rclpy=ran.rclpy, python=ran.python))


def _stored_tries(result: Result) -> Iterator[tuple[str, str, bool]]:
    """Yield each stored try's recording, the reason why it was inconclusive, and whether only its end was.

    A try without a recording, during which the slot failed, is left out.
    """
    if not result.tries and result.recording is not None:
        yield result.recording, result.inconclusive_reason, False
    for one in result.tries:
        if one.recording is not None:
            yield one.recording, one.inconclusive_reason, one.end_only


def _judged_again(
    path: Path, inconclusive_reason: str, end_only: bool, exercise: Exercise, answer_sha256: str
) -> Judgement:
    """Judge a stored recording again. Raises CannotRegrade if that's impossible."""
    try:
        recording = Recording.load(path)
    except (OSError, ValueError, TypeError) as error:
        raise CannotRegrade(f"its recording cannot be read: {error}") from error
    if kept_from_simulated_time(recording):
        raise CannotRegrade(
            "a run in simulated time decided some results, and only the other run was recorded"
        )
    judgement = judge_recording(exercise, answer_sha256, recording)
    if judgement.status != "graded":
        raise CannotRegrade(judgement.reason or "the criteria failed")
    if judgement.full_marks:
        return replace(judgement, inconclusive_reason=script_cut_short(recording))
    return replace(judgement, inconclusive_reason=inconclusive_reason, end_only=end_only)
