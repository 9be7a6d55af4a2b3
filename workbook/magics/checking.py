"""Judge the answer file for `%check` in a judge that's already running (a "warm" slot), and build the result card."""

import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from workbook.criteria.runner import CriterionResult
from workbook.exercise.answers import Answer
from workbook.exercise.course import course_folder
from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import Judgement
from workbook.exercise.retries import until_sure
from workbook.exercise.source import stems
from workbook.feedback import wording
from workbook.feedback.card import Card, Extras
from workbook.feedback.moment import Film, Moment, gained, what_comes_next
from workbook.feedback.review import review_prompt
from workbook.feedback.timeline import judged_timeline
from workbook.grading.slots.client import ShowProgress, SlotBroken
from workbook.grading.slots.pool import Kind, warm_slots
from workbook.grading.slots.service import ADDRESS, judge_there
from workbook.lesson.best_answers import Check
from workbook.lesson.progress import all_progress
from workbook.magics.screen import Version


def warm_up() -> None:
    """Start the slot for the next answer in the background, unless the class's service judges it.

    Call this in the main thread, because a slot is terminated when the thread that started it finishes.
    """
    if not os.environ.get(ADDRESS):
        warm_slots.warm_up(Kind())


def judge(
    stem: str,
    answer: Answer,
    report: Callable[[Judgement], None],
    stop: Callable[[], bool] = lambda: False,
    progress: ShowProgress | None = None,
) -> Judgement:
    """Judge an answer in the warm slot, or send it to the class's judging service.

    While the result is inconclusive and `stop()` returns False, judge the answer again, at most three times.
    """

    service = os.environ.get(ADDRESS)

    def once() -> Judgement:
        if service:
            return judge_there(service, stem, answer, report, progress, stop)
        slot = warm_slots.take(Kind())
        try:
            judgement = slot.judge(stem, answer, soak=True, report=report, progress=progress)
        except SlotBroken as error:
            warm_slots.drop(slot)
            return Judgement(stem, answer.sha256, "infra_error", str(error), (), None)
        warm_slots.give(Kind(), slot)
        return judgement

    return until_sure(once, report, stop)


def _timeline(
    exercise: Exercise, judgement: Judgement, first: CriterionResult | None
) -> tuple[bytes | None, str]:
    """Draw a timeline of the messages if the first failed criterion is about time.

    Return the PNG bytes and the alternative text, or None and an empty string.
    """
    if first is None or not first.about_time or judgement.recording is None:
        return None, ""
    return judged_timeline(exercise, judgement.recording)


@dataclass(frozen=True)
class Asked:
    """The input of a `%check`: the exercise, the answer to judge, and details for the result card.

    `version`: the version of the answer that was run if we couldn't read the one on the screen, or None otherwise.
    `replays`: whether the notebook's front end, rather than the kernel, animates the robot on the result card.
    """

    exercise: Exercise
    answer: Answer
    file: Path
    hints_left: int
    version: Version | None
    kept: Check
    replays: bool = False


def deserves_praise(asked: Asked, judgement: Judgement) -> bool:
    """Return whether the judged text got full marks and, as far as we know, is also the text on the screen."""
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
    words = gained(asked.kept.before.best, now, solved, len(exercises))
    return Moment(words, title, link, film, asked.replays)


def _better_line(asked: Asked, judgement: Judgement) -> str:
    counts = judgement.status == "graded" and not judgement.provisional
    best = None if not counts else asked.kept.best_of_another_version()
    if best is None:
        return ""
    most = wording.points(wording.shown_points(judgement)[1])
    return (
        f"Your best version, with {wording.points(best)} of {most} points, is saved, and you keep those points. But "
        "the file to hand in now contains a different version."
    )


def card_for(asked: Asked, judgement: Judgement, film: Film | None = None) -> Card:
    """Build the complete card. `film` shows the moving robot; it's None until it has been drawn."""
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
