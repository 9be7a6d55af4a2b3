"""Feedback as a card in a notebook: readable on light and dark, without styles, and in an untrusted notebook."""

import base64
from dataclasses import dataclass

from workbook.exercise.judgement import Judgement
from workbook.exercise.museum import Exhibit
from workbook.feedback import wording
from workbook.templating import render

COLORS = {"passed": "#208a3c", "failed": "#dc3b3b", "partial": "#b06a00", "skipped": "#787878"}
BLUE = "#2f78d0"


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


def _color_of(judgement: Judgement) -> str:
    if judgement.provisional:
        return COLORS["partial"]
    if wording.all_shown_hold(judgement):
        return COLORS["passed"]
    return COLORS["partial"] if wording.shown_points(judgement)[0] else COLORS["failed"]


def as_html(judgement: Judgement, extras: Extras | None = None) -> str:
    """The card. All text of the program is escaped; colors are plain hex values with a word beside each."""
    extras = extras or Extras()
    holds = wording.all_shown_hold(judgement)
    score, most = wording.shown_points(judgement)
    return render(
        "feedback/card",
        extras=extras,
        color=_color_of(judgement),
        colors=COLORS,
        signs=wording.SIGNS,
        words=wording.WORDS,
        sign="✓" if holds else "◔" if judgement.provisional else "➜",
        headline=wording.headline(judgement),
        score=score,
        most=most,
        provisional_line=wording.provisional_line(judgement),
        doubt_line=wording.doubt_line(judgement),
        first=wording.first_to_mend(judgement),
        later=wording.also_to_mend(judgement),
        shown=wording.visible(judgement),
        timeline=None if extras.timeline is None else base64.b64encode(extras.timeline).decode(),
        log=wording.printed(judgement).strip(),
        is_done=holds and not judgement.provisional,
        small=" ".join(filter(None, (wording.clock_line(judgement), wording.hidden_line(judgement)))),
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
        return line if first is None else f"{line} Fix first: {first.title}."
