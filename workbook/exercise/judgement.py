"""Define the judgment of one answer. Judging a stored recording doesn't run a program and doesn't need ROS."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

from workbook.criteria.runner import CriterionError, CriterionResult, run_criteria
from workbook.criteria.vocabulary.driver import only_signed
from workbook.exercise.definition import Exercise
from workbook.recording.recording import Recording

JudgementStatus = Literal["graded", "ungradable", "infra_error"]


@dataclass(frozen=True)
class Judgement:
    """The result for one answer.

    `provisional`: whether a later judgment, on the wall clock or in another try, may replace this judgment.
    `inconclusive_reason`: why the judgment may be unfair to the answer (see `inconclusive`), or "" for a conclusive
    judgment. `end_only`: whether only the points for the program's exit are inconclusive. `watched_real_life`: whether
    the program was also watched in real time.
    """

    stem: str
    answer_sha256: str
    status: JudgementStatus
    reason: str | None
    criteria: tuple[CriterionResult, ...]
    recording: Recording | None
    provisional: bool = False
    watched_real_life: bool = False
    inconclusive_reason: str = ""
    end_only: bool = False

    @property
    def score(self) -> float | None:
        """The points earned, including hidden criteria, or None if the answer couldn't be judged."""
        if self.status != "graded":
            return None
        return round(sum(result.points for result in self.criteria), 6)

    @property
    def is_inconclusive(self) -> bool:
        """Whether the machine or the judge may have cost points other than those for the program's exit."""
        return bool(self.inconclusive_reason) and not self.end_only

    @property
    def max_score(self) -> float:
        """The maximum points, including hidden criteria."""
        return sum(result.max_points for result in self.criteria)

    @property
    def full_marks(self) -> bool:
        """Whether every criterion passed."""
        return self.status == "graded" and all(result.status == "passed" for result in self.criteria)


Report = Callable[[Judgement], None]

KEPT = "decided in simulated time: "
"""The beginning of a recording's note about results that only another recording shows, which isn't stored."""


def judge_recording(
    exercise: Exercise,
    answer_sha256: str,
    recording: Recording,
    *,
    provisional: bool = False,
    real_life: bool = False,
) -> Judgement:
    """Judge a recording without running anything. If a criterion crashes, the judgment is an `infra_error`."""
    try:
        results = run_criteria(exercise.criteria, only_signed(recording, exercise.signed))
    except CriterionError as error:
        return Judgement(exercise.stem, answer_sha256, "infra_error", str(error), (), recording)
    return Judgement(exercise.stem, answer_sha256, "graded", None, results, recording, provisional, real_life)


def judgement_as_provisional(judgement: Judgement) -> Judgement:
    """Return the judgment, marked as not final."""
    return replace(judgement, provisional=True)


def kept_from_simulated_time(recording: Recording) -> frozenset[str]:
    """Return the IDs of the criteria whose results a recording of a run on the wall clock doesn't show.

    A run in simulated time decided them.
    """
    note = next((note.removeprefix(KEPT) for note in recording.notes if note.startswith(KEPT)), "")
    return frozenset(note.split())


def with_kept_results(before: Judgement, again: Judgement) -> Judgement:
    """Return `again`, a new judgment of the recording of `before`, with the results that simulated time decided."""
    kept = kept_from_simulated_time(before.recording) if before.recording is not None else frozenset()
    results = {one.id: one for one in before.criteria if one.id in kept}
    return replace(again, criteria=tuple(results.get(one.id, one) for one in again.criteria))
