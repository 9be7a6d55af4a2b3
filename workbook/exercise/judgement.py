"""A judgement: what came out for one answer. Making one of a stored recording runs nothing and needs no ROS."""

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
    """What came out for one answer.

    `provisional`: another judgement, on the wall clock or in another try, is still to come and may differ.
    `inconclusive_reason`: why points that were lost may be lost without the answer's fault; empty for a conclusive
    judgement. `end_only`: the doubt is about the program's end alone, and everything else is conclusive.
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
        """The points, hidden criteria included; None when the answer could not be judged."""
        if self.status != "graded":
            return None
        return round(sum(result.points for result in self.criteria), 6)

    @property
    def is_disturbed(self) -> bool:
        """Whether the machine or the judge may have cost points, and not only at the program's end."""
        return bool(self.inconclusive_reason) and not self.end_only

    @property
    def max_score(self) -> float:
        """The points that there are, hidden criteria included."""
        return sum(result.max_points for result in self.criteria)

    @property
    def full_marks(self) -> bool:
        """Whether every criterion passed."""
        return self.status == "graded" and all(result.status == "passed" for result in self.criteria)


Report = Callable[[Judgement], None]


def judge_recording(
    exercise: Exercise,
    answer_sha256: str,
    recording: Recording,
    *,
    provisional: bool = False,
    real_life: bool = False,
) -> Judgement:
    """Judge a recording without running anything. A criterion that crashes gives an `infra_error`."""
    try:
        results = run_criteria(exercise.criteria, only_signed(recording, exercise.signed))
    except CriterionError as error:
        return Judgement(exercise.stem, answer_sha256, "infra_error", str(error), (), recording)
    return Judgement(exercise.stem, answer_sha256, "graded", None, results, recording, provisional, real_life)


def judgement_as_provisional(judgement: Judgement) -> Judgement:
    """The same judgement, marked as not final."""
    return replace(judgement, provisional=True)
