"""A student's page in the gradebook. It needs no network and no script. (The class has `class_page`.)"""

import hashlib
import re
from pathlib import Path

from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import Judgement
from workbook.feedback.card import Extras, as_html
from workbook.feedback.colors import ON_DARK, ON_LIGHT, variables
from workbook.feedback.timeline import judged_timeline
from workbook.grading.results import Result, criterion_result
from workbook.recording.recording import Recording
from workbook.templating import as_markup, render

PAGES = "pages"
CLASS = "class.html"
TEXT_COLORS = {"light": variables(ON_LIGHT), "dark": variables(ON_DARK)}
"""Declarations for the style of a page, by theme."""


def page_name(student: str, exercise: str) -> str:
    """A file name that no two students share, whatever they are called."""
    plain = re.sub(r"[^A-Za-z0-9]+", "-", student).strip("-").lower()[:40]
    return (
        f"{exercise}-{plain}-{hashlib.sha256(student.encode('utf-8', 'surrogatepass')).hexdigest()[:8]}.html"
    )


def judgement_of(result: Result, out: Path) -> Judgement:
    """The judgement that a result tells of, with its stored recording where there is one."""
    recording = None
    if result.recording is not None:
        try:
            recording = Recording.load(out / result.recording)
        except (OSError, ValueError):
            recording = None
    return Judgement(
        stem=result.exercise,
        answer_sha256=result.answer_sha256,
        status="graded" if result.status == "graded" else "infra_error",
        reason=result.reason,
        criteria=tuple(map(criterion_result, result.criteria)),
        recording=recording,
        inconclusive_reason=result.inconclusive_reason,
    )


def student_page(result: Result, exercise: Exercise, out: Path) -> str:
    """One student's page: the card, when messages were expected and came, and the log."""
    judgement = judgement_of(result, out)
    timeline, words = None, ""
    if judgement.recording is not None and exercise.periods:
        timeline, words = judged_timeline(exercise, judgement.recording)
    return render(
        "grading/student",
        title=f"{exercise.source.title}: {result.student}",
        text_colors=TEXT_COLORS,
        result=result,
        card=as_markup(as_html(judgement, Extras(timeline=timeline, timeline_text=words, is_graded=True))),
    )
