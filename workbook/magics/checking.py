"""`%check`: judge the answer file on a warm slot and show the card."""

import atexit
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from workbook.criteria.runner import CriterionResult
from workbook.exercise.answers import Answer
from workbook.exercise.course import course_folder
from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import Judgement
from workbook.exercise.source import stems
from workbook.feedback import wording
from workbook.feedback.card import Card, Extras
from workbook.feedback.moment import Film, Moment, gained, what_comes_next
from workbook.feedback.review import review_prompt
from workbook.feedback.timeline import judged_timeline
from workbook.grading.pool import Slot, SlotBroken
from workbook.grading.retries import until_sure
from workbook.lesson.best_answers import Check
from workbook.lesson.progress import all_progress
from workbook.magics.screen import Version

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


@dataclass(frozen=True)
class Asked:
    """One `%check`: what is judged. `version`: which one it is, where the screen could not be asked."""

    exercise: Exercise
    answer: Answer
    file: Path
    hints_left: int
    version: Version | None
    kept: Check


def deserves_praise(asked: Asked, judgement: Judgement) -> bool:
    """Whether these are full marks, for what is on the screen as far as one knows."""
    differs = asked.version is not None and asked.version.differs
    return wording.all_shown_hold(judgement) and not judgement.provisional and not differs


def _moment(asked: Asked, judgement: Judgement, film: Film | None) -> Moment | None:
    if not deserves_praise(asked, judgement):
        return None
    course = course_folder()
    exercises = set(stems(course / "solutions"))
    solved = sum(kept.solved for stem, kept in all_progress().items() if stem in exercises)
    now = wording.shown_points(judgement)[0]
    title, link = what_comes_next(course, asked.exercise.stem)
    return Moment(gained(asked.kept.before.best, now, solved, len(exercises)), title, link, film)


def _better_line(asked: Asked, judgement: Judgement) -> str:
    counts = judgement.status == "graded" and not judgement.provisional
    best = None if not counts else asked.kept.best_of_another_version()
    if best is None:
        return ""
    most = wording.points(wording.shown_points(judgement)[1])
    return (
        f"Your best version, with {wording.points(best)} of {most} points, is kept, and so are its points. "
        "The file to hand in now holds another one."
    )


def card_for(asked: Asked, judgement: Judgement, film: Film | None = None) -> Card:
    """The card with everything that belongs on it. `film`: the robot in motion, once it is drawn."""
    exercise, answer = asked.exercise, asked.answer
    first = wording.first_to_mend(judgement)
    timeline, timeline_text = _timeline(exercise, judgement, first)
    return Card(
        judgement,
        Extras(
            file=str(asked.file),
            review=review_prompt(exercise.source, answer.text, judgement)
            if wording.all_shown_hold(judgement)
            else "",
            timeline=timeline,
            timeline_text=timeline_text,
            has_rates=bool(exercise.periods),
            hints_left=asked.hints_left,
            exhibit=wording.exhibit_of(judgement),
            version_line=asked.version.line("This card judges") if asked.version else "",
            is_on_screen=asked.version is None or not asked.version.differs,
            better_line=_better_line(asked, judgement),
            moment=_moment(asked, judgement, film),
        ),
    )
