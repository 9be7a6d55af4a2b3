"""Render a student's page in the gradebook.

The page doesn't need a network connection or a script. For the page about the class, see `class_page`.
"""

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
"""The CSS declarations of a page's text colors, keyed by theme."""


def page_name(student: str, exercise: str) -> str:
    """Return a file name that's unique to this student, whatever characters the student's name contains."""
    plain = re.sub(r"[^A-Za-z0-9]+", "-", student).strip("-").lower()[:40]
    return (
        f"{exercise}-{plain}-{hashlib.sha256(student.encode('utf-8', 'surrogatepass')).hexdigest()[:8]}.html"
    )


def judgement_of(result: Result, out: Path) -> Judgement:
    """Rebuild the judgment from a result and, if it can be read, the result's stored recording."""
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
    """Return one student's page: the feedback card, the expected and received messages over time, and the log."""
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
