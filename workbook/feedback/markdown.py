"""Write feedback as Markdown for a GitHub page, where a program's output never becomes a link, image, or tag."""

import re
import string

from workbook.criteria.runner import CriterionResult
from workbook.exercise.judgement import Judgement
from workbook.feedback import wording
from workbook.recording.plain_text import without_commands
from workbook.templating import as_markup, render

_SPACE = re.compile(r"\s+")
_PUNCTUATION = re.compile(f"[{re.escape(string.punctuation)}]")


def plain(text: str) -> str:
    """Return `text` on one line, with punctuation as HTML entities, so that Markdown and HTML render it literally."""
    return _PUNCTUATION.sub(
        lambda found: f"&#{ord(found[0])};", _SPACE.sub(" ", without_commands(text)).strip()
    )


def plain_markup(text: str) -> str:
    """Return `text` as `plain` does, but marked as markup, so that a template doesn't escape it again."""
    return as_markup(plain(text))


def as_markdown(judgement: Judgement) -> str:
    """Return the feedback: the headline, the first thing to fix, every criterion, and the program's output."""
    parts = [f"**{plain(wording.headline(judgement))}**"]
    first = wording.first_to_mend(judgement)
    if first is not None:
        parts += [f"Start with this criterion: {plain(first.title)}", _advice(first)]
    shown = wording.worst_first(judgement)
    if shown:
        parts.append(
            render(
                "feedback/github_criteria",
                shown=shown,
                signs=wording.SIGNS,
                words=wording.WORDS,
                earned=wording.earned,
                plain=plain_markup,
            )
        )
    for line in (
        wording.inconclusive_line(judgement, is_graded=True),
        wording.hidden_line(judgement),
        wording.clock_line(judgement),
    ):
        if line:
            parts.append(plain(line))
    log = wording.printed(judgement).strip()
    if log:
        parts.append(render("feedback/github_log", log=log))
    return "\n\n".join(parts)


def _advice(result: CriterionResult) -> str:
    advice = (
        ("What we saw", result.saw),
        ("Expected", result.expected),
        ("Likely cause", result.because),
        ("Try", result.try_this),
    )
    return render("feedback/github_advice", advice=advice, plain=plain_markup)
