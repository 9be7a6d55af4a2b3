"""Feedback as Markdown for a page of GitHub, where no text of a program becomes a link, a picture or a tag."""

import re
import string
from html import escape

from workbook.criteria.runner import CriterionResult
from workbook.exercise.judging import Judgement
from workbook.feedback import wording

_SPACE = re.compile(r"\s+")
_PUNCTUATION = re.compile(f"[{re.escape(string.punctuation)}]")


def plain(text: str) -> str:
    """Text on one line that means nothing but itself, in Markdown and in HTML: all punctuation as entities."""
    return _PUNCTUATION.sub(lambda found: f"&#{ord(found[0])};", _SPACE.sub(" ", text).strip())


def _row(result: CriterionResult) -> str:
    state = f"{wording.SIGNS[result.status]} {wording.WORDS[result.status]}"
    earned = f"{wording.points(result.points)} of {wording.points(result.max_points)}"
    return f"<tr><td>{state}</td><td>{earned}</td><td>{plain(result.title)}</td><td>{plain(result.saw)}</td></tr>"


def _advice(result: CriterionResult) -> str:
    lines = (
        ("You showed", result.saw),
        ("Expected", result.expected),
        ("Likely reason", result.because),
        ("Try", result.try_this),
    )
    rows = "".join(f"<tr><th>{label}</th><td>{plain(text)}</td></tr>" for label, text in lines if text)
    return f"<table>{rows}</table>"


def as_markdown(judgement: Judgement) -> str:
    """The card: the headline, the first thing to mend, every criterion, and what the program printed."""
    parts = [f"**{plain(wording.headline(judgement))}**"]
    first = wording.first_to_mend(judgement)
    if first is not None:
        parts += [f"First to mend: {plain(first.title)}", _advice(first)]
    shown = wording.visible(judgement)
    if shown:
        head = "<tr><th>State</th><th>Points</th><th>Criterion</th><th>Seen on the wire</th></tr>"
        parts.append(f"<table>{head}{''.join(map(_row, shown))}</table>")
    for line in (
        wording.doubt_line(judgement),
        wording.hidden_line(judgement),
        wording.clock_line(judgement),
    ):
        if line:
            parts.append(plain(line))
    recording = judgement.recording
    log = "" if recording is None else (recording.process.log + recording.process.end_log).strip()
    if log:
        parts += [
            "<details><summary>What your program printed</summary>",
            f"<pre>{escape(log)}</pre>",
            "</details>",
        ]
    return "\n\n".join(parts)
