"""The card of one check: shown at the first judgement, replaced by each later one."""

import threading
from contextlib import suppress

from IPython.display import DisplayHandle, display

from workbook.exercise.judgement import Judgement
from workbook.feedback.card import Card
from workbook.feedback.moment import Film, film_of
from workbook.magics import checking
from workbook.magics.checking import Asked


class LiveCard:
    """`judge` runs in a thread. `decided` is set as soon as a card shows that is not provisional, or none can come.

    `judgement` is what the card shows then.
    """

    def __init__(self, asked: Asked) -> None:
        self.decided = threading.Event()
        self.abandoned = threading.Event()
        self.judgement: Judgement | None = None
        self._asked = asked
        self._handle: DisplayHandle | None = None
        self._film: Film | None = None

    def judge(self) -> None:
        """Judge, and show what comes out."""
        try:
            self._show(checking.judge(self._asked.exercise.stem, self._asked.answer, self._show))
        finally:
            self.decided.set()

    def _show(self, judgement: Judgement) -> None:
        if self.abandoned.is_set():
            return
        if not judgement.provisional:
            self.judgement = judgement
            with suppress(OSError):  # a full disk costs the note, and not the card
                self._asked.kept.note(judgement)
        self._put(checking.card_for(self._asked, judgement, self._film))
        if judgement.provisional:
            return
        self.decided.set()
        if self._film is None and checking.deserves_praise(self._asked, judgement):
            self._add_the_film(judgement)

    def _add_the_film(self, judgement: Judgement) -> None:
        """Have the robot move on the card, which is there already: to draw it takes about a second."""
        try:
            self._film = film_of(judgement.recording) if judgement.recording else None
        except Exception:
            return  # a picture that cannot be drawn must not cost the judgement that is still under way
        self._put(checking.card_for(self._asked, judgement, self._film))

    def _put(self, card: Card) -> None:
        if self._handle is None:
            self._handle = display(card, display_id=True)
        else:
            self._handle.update(card)
