"""Show feedback as a *card*: the HTML output of a cell.

The card is readable in light and dark themes, without styles, and in untrusted notebooks.
"""

import base64
from dataclasses import dataclass

from workbook.exercise.judgement import Judgement
from workbook.exercise.museum import Exhibit
from workbook.feedback import wording
from workbook.feedback.colors import COLORS, ON_DARK, ON_LIGHT, TEXT, TINTS, variables
from workbook.feedback.moment import Moment
from workbook.templating import render


@dataclass(frozen=True)
class Extras:
    """The optional parts of a card, in addition to the judgment.

    `timeline`: a PNG, which `timeline_text` describes. `has_rates`: whether the timeline shows when messages were due.
    `is_graded`: whether the card is part of a gradebook, so that no other try follows. `version_line`: a sentence that
    names the judged version if the cell on the screen couldn't be read. `is_on_screen`: whether the screen shows the
    judged version. `better_line`: a sentence about an earlier, better version. `moment`: the reward for full marks.
    """

    file: str = ""
    review: str = ""
    timeline: bytes | None = None
    timeline_text: str = ""
    has_rates: bool = True
    hints_left: int = 0
    exhibit: Exhibit | None = None
    is_graded: bool = False
    version_line: str = ""
    is_on_screen: bool = True
    better_line: str = ""
    moment: Moment | None = None


def _state_of(judgement: Judgement, is_on_screen: bool) -> str:
    """Return the criterion state whose color the whole card gets."""
    if judgement.provisional or not is_on_screen:
        return "partial"
    if wording.all_shown_hold(judgement):
        return "passed"
    return "partial" if wording.shown_points(judgement)[0] else "failed"


def _headline(judgement: Judgement, extras: Extras) -> str:
    """Return the headline. It doesn't praise a version that isn't on the screen."""
    if extras.is_on_screen or not wording.all_shown_hold(judgement):
        return wording.headline(judgement)
    score, most = map(wording.points, wording.shown_points(judgement))
    return f"{score} of {most} points, for a version that is not on your screen."


def as_html(judgement: Judgement, extras: Extras | None = None) -> str:
    """Return the card as HTML. The program's output is escaped, and words repeat the colors' meaning (see `colors`)."""
    extras = extras or Extras()
    holds = wording.all_shown_hold(judgement) and extras.is_on_screen
    score, most = wording.shown_points(judgement)
    film = extras.moment.film if extras.moment else None
    return render(
        "feedback/card",
        extras=extras,
        state=_state_of(judgement, extras.is_on_screen),
        colors=COLORS,
        text=TEXT,
        tints=TINTS,
        on_light=variables(ON_LIGHT),
        on_dark=variables(ON_DARK),
        signs=wording.SIGNS,
        words=wording.WORDS,
        sign="✓" if holds else "◔" if judgement.provisional else "➜",
        headline=_headline(judgement, extras),
        score=score,
        most=most,
        provisional_line=wording.provisional_line(judgement),
        inconclusive_line=wording.inconclusive_line(judgement, is_graded=extras.is_graded),
        first=wording.first_to_mend(judgement),
        later=wording.also_to_mend(judgement),
        shown=wording.worst_first(judgement),
        earned=wording.earned,
        timeline=None if extras.timeline is None else base64.b64encode(extras.timeline).decode(),
        log=wording.printed(judgement).strip(),
        is_done=holds and not judgement.provisional,
        number=judgement.stem[:2],
        moment=extras.moment,
        moving=base64.b64encode(film.moving).decode() if film else "",
        still=base64.b64encode(film.still).decode() if film else "",
        small=" ".join(filter(None, (wording.clock_line(judgement), wording.hidden_line(judgement)))),
    )


class Card:
    """A judgment for display in JupyterLab. Its plain-text form is the same in every run with the same result."""

    def __init__(self, judgement: Judgement, extras: Extras | None = None) -> None:
        self.judgement = judgement
        self._extras = extras or Extras()

    def _repr_html_(self) -> str:
        return as_html(self.judgement, self._extras)

    def __repr__(self) -> str:
        first = wording.first_to_mend(self.judgement)
        line = _headline(self.judgement, self._extras)
        return line if first is None else f"{line} Start with this criterion: {first.title}."
