"""Feedback as a card in a notebook: readable on light and dark, without styles, and in an untrusted notebook."""

import base64
from dataclasses import dataclass
from html import escape

from workbook.criteria.runner import CriterionResult
from workbook.exercise.judging import Judgement
from workbook.exercise.museum import Exhibit
from workbook.feedback import wording

COLORS = {"passed": "#208a3c", "failed": "#dc3b3b", "partial": "#b06a00", "skipped": "#787878"}
BLUE = "#2f78d0"
# JupyterLab aligns cells to the right and breaks lines of preformatted text inside words.
_CELL = "text-align:left;vertical-align:top;padding:3px 14px 3px 0"
_PRE = "white-space:pre-wrap;word-break:normal;overflow-wrap:anywhere;margin:4px 0"
_TIMELINE_KEY = "Colored: messages that came."
_TIMELINE_KEY_OF_RATES = "Thin and gray: when one was due."


@dataclass(frozen=True)
class Extras:
    """What a card may carry besides the judgement.

    `timeline` is a PNG and `timeline_text` describes it; `has_rates` says whether it shows when messages were due.
    """

    file: str = ""
    review: str = ""
    timeline: bytes | None = None
    timeline_text: str = ""
    has_rates: bool = True
    hints_left: int = 0
    exhibit: Exhibit | None = None


def _status(result: CriterionResult) -> str:
    word = wording.WORDS[result.status]
    return f'<b style="color:{COLORS[result.status]}">{wording.SIGNS[result.status]} {word}</b>'


def _row(result: CriterionResult) -> str:
    earned = f"{wording.points(result.points)} of {wording.points(result.max_points)}"
    saw = escape(result.saw) if result.status != "skipped" else "<i>looked at once the line above holds</i>"
    return (
        f'<tr><td style="{_CELL};white-space:nowrap">{_status(result)}</td>'
        f'<td style="{_CELL};white-space:nowrap">{earned}</td>'
        f'<td style="{_CELL}">{escape(result.title)}</td><td style="{_CELL}">{saw}</td></tr>'
    )


def _advice(result: CriterionResult) -> str:
    lines = [
        ("You showed", result.saw),
        ("Expected", result.expected),
        ("Likely reason", result.because),
        ("Try", result.try_this),
    ]
    # A body for each row: JupyterLab stripes the rows of one body, and these four belong together.
    rows = "".join(
        f'<tbody><tr><td style="{_CELL};white-space:nowrap"><b>{label}</b></td>'
        f'<td style="{_CELL}">{escape(text)}</td></tr></tbody>'
        for label, text in lines
        if text
    )
    return f'<table style="margin:0 0 8px 0">{rows}</table>'


def _bar(judgement: Judgement) -> str:
    score, most = wording.shown_points(judgement)
    return (
        f'<progress value="{score:g}" max="{most:g}" aria-label="points" style="accent-color:{_color_of(judgement)}">'
        f"{score:g} of {most:g}</progress>"
    )


def _color_of(judgement: Judgement) -> str:
    if judgement.provisional:
        return COLORS["partial"]
    if wording.all_shown_hold(judgement):
        return COLORS["passed"]
    return COLORS["partial"] if wording.shown_points(judgement)[0] else COLORS["failed"]


def _fold(summary: str, html: str) -> str:
    return f'<details style="margin:6px 0"><summary>{summary}</summary>{html}</details>'


def _pre(text: str) -> str:
    return f'<pre style="{_PRE}">{escape(text)}</pre>'


def _log(judgement: Judgement) -> str:
    recording = judgement.recording
    if recording is None:
        return ""
    log = (recording.process.log + recording.process.end_log).strip()
    if not log:
        return ""
    return _fold("What your program printed", _pre(log))


def as_html(judgement: Judgement, extras: Extras | None = None) -> str:
    """The card. All text of the program is escaped; colors are plain hex values with a word beside each."""
    extras = extras or Extras()
    color = _color_of(judgement)
    sign = "✓" if wording.all_shown_hold(judgement) else "◔" if judgement.provisional else "➜"
    parts = [
        f'<div style="border-left:6px solid {color};padding:4px 0 4px 14px">',
        f'<p style="font-size:115%;margin:0 0 8px 0"><b style="color:{color}">{sign} '
        f"{escape(wording.headline(judgement))}</b> &nbsp;{_bar(judgement)}</p>",
    ]
    if judgement.provisional:
        parts.append(
            f'<p style="margin:4px 0;color:{color}">{escape(wording.provisional_line(judgement))}</p>'
        )
    if doubt := wording.doubt_line(judgement):
        parts.append(f'<p style="margin:4px 0;color:{COLORS["partial"]}">{escape(doubt)}</p>')
    first = wording.first_to_mend(judgement)
    if first is not None:
        parts.append(
            f'<p style="margin:0 0 4px 0"><b>First to mend: {escape(first.title)}</b></p>{_advice(first)}'
        )
        if extras.exhibit is not None:
            parts.append(_exhibit(extras.exhibit))
    if extras.timeline is not None:
        data = base64.b64encode(extras.timeline).decode()
        key = f"{_TIMELINE_KEY} {_TIMELINE_KEY_OF_RATES}" if extras.has_rates else _TIMELINE_KEY
        parts.append(
            f'<p style="margin:0 0 8px 0"><img alt="{escape(extras.timeline_text)}" '
            f'src="data:image/png;base64,{data}"><br>'
            f'<small style="color:{COLORS["skipped"]}">{key}</small></p>'
        )
    parts.append(_table(judgement))
    later = wording.also_to_mend(judgement)
    if later:
        folded = "".join(f"<p><b>{escape(result.title)}</b></p>{_advice(result)}" for result in later)
        what = "the other one" if len(later) == 1 else f"the other {len(later)}"
        parts.append(_fold(f"Reasons for {what}", folded))
    if wording.all_shown_hold(judgement) and not judgement.provisional and extras.file:
        parts.append(f'<p style="margin:6px 0">Hand in this file: <code>{escape(extras.file)}</code></p>')
    parts.append(_log(judgement))
    if wording.all_shown_hold(judgement) and not judgement.provisional:
        parts.append(_last_step(extras))
    elif first is not None and extras.hints_left:
        parts.append('<p style="margin:6px 0">Stuck? <code>%hint</code> gives the next hint.</p>')
    small = " ".join(filter(None, (wording.clock_line(judgement), wording.hidden_line(judgement))))
    parts.append(
        f'<p style="color:{COLORS["skipped"]};margin:4px 0 0 0"><small>{escape(small)}</small></p></div>'
    )
    return "".join(parts)


def _exhibit(exhibit: Exhibit) -> str:
    """The way to the error museum and to the lesson that shows this live."""
    lesson = f"../notebooks/{exhibit.lesson}.ipynb"
    return (
        f'<p style="margin:0 0 8px 0">Seen before: <code>{escape(exhibit.symptom)}</code> hangs in the '
        f'<a href="../notebooks/error_museum.md">error museum</a>, and lesson '
        f'<a href="{lesson}">{exhibit.lesson[:2]}</a> shows it live.</p>'
    )


def _table(judgement: Judgement) -> str:
    rows = "".join(map(_row, wording.visible(judgement)))
    return (
        f'<table style="margin:0 0 8px 0"><thead><tr><th style="{_CELL}">State</th><th style="{_CELL}">Points</th>'
        f'<th style="{_CELL};width:38%">Criterion</th><th style="{_CELL}">Seen on the wire</th></tr></thead>'
        f"<tbody>{rows}</tbody></table>"
    )


def _last_step(extras: Extras) -> str:
    if not extras.review:
        return ""
    return _fold(
        "One last step: a review. A prompt to give to a colleague or an AI assistant", _pre(extras.review)
    )


class Card:
    """A judgement as JupyterLab shows it; its text form is the same in every run with the same outcome."""

    def __init__(self, judgement: Judgement, extras: Extras | None = None) -> None:
        self.judgement = judgement
        self._extras = extras

    def _repr_html_(self) -> str:
        return as_html(self.judgement, self._extras)

    def __repr__(self) -> str:
        first = wording.first_to_mend(self.judgement)
        line = wording.headline(self.judgement)
        return line if first is None else f"{line} First to mend: {first.title}."
