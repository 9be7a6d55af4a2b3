"""`%check`: judge the answer file on a warm slot and show the card."""

import atexit
from collections.abc import Callable
from pathlib import Path

from workbook.criteria.runner import CriterionResult
from workbook.exercise.answers import Answer
from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import Judgement
from workbook.feedback import wording
from workbook.feedback.card import Card, Extras
from workbook.feedback.review import review_prompt
from workbook.feedback.timeline import judged_timeline
from workbook.grading.pool import Slot, SlotBroken
from workbook.grading.retries import until_sure

_slot: Slot | None = None


def warm_slot() -> Slot:
    """The slot of this kernel, started at first use. It ends with the kernel."""
    global _slot
    if _slot is None or not _slot.is_running:
        _slot = Slot()
    return _slot


def close_slot() -> None:
    """End the slot of this kernel; does nothing when there is none."""
    global _slot
    if _slot is not None:
        _slot.close()
        _slot = None


def finish_soon() -> None:
    """Have the slot finish the judgement under way soon."""
    if _slot is not None and _slot.is_running:
        _slot.enough()


def kill_slot() -> None:
    """End the slot at once, and with it the program that it watches."""
    global _slot
    if _slot is not None:
        _slot.kill()
        _slot.close()
        _slot = None


atexit.register(close_slot)


def judge(stem: str, answer: Answer, report: Callable[[Judgement], None]) -> Judgement:
    """Judge on the warm slot, as the instructor's grader does: what is inconclusive is tried once more."""

    def once() -> Judgement:
        slot = warm_slot()
        try:
            return slot.judge(stem, answer, thorough=True, report=report)
        except SlotBroken as error:
            slot.kill()
            return Judgement(stem, answer.sha256, "infra_error", str(error), (), None)

    return until_sure(once, report)


def _timeline(
    exercise: Exercise, judgement: Judgement, first: CriterionResult | None
) -> tuple[bytes | None, str]:
    """A picture of the arrivals when the first failed criterion is about time."""
    if first is None or not first.about_time or judgement.recording is None:
        return None, ""
    return judged_timeline(exercise, judgement.recording)


def card_for(exercise: Exercise, answer: Answer, file: Path, judgement: Judgement, hints_left: int) -> Card:
    """The card with everything that belongs on it."""
    first = wording.first_to_mend(judgement)
    timeline, timeline_text = _timeline(exercise, judgement, first)
    return Card(
        judgement,
        Extras(
            file=str(file),
            review=review_prompt(exercise.source, answer.text, judgement)
            if wording.all_shown_hold(judgement)
            else "",
            timeline=timeline,
            timeline_text=timeline_text,
            has_rates=bool(exercise.periods),
            hints_left=hints_left,
            exhibit=wording.exhibit_of(judgement),
        ),
    )
