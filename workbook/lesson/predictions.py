"""Ask for predictions before a run, and show afterward whether they were right.

`predict("late-joiner")` asks, and `reveal("late-joiner", late=...)` after the run shows the outcome. Until then, a
choice may be changed. A reader who hasn't chosen sees no outcome.
"""

import os
from functools import cache
from typing import Any

from workbook.lesson.activity import kept_choice, note_outcome_seen, note_prediction
from workbook.lesson.front_end import asked, show_prediction
from workbook.lesson.older_predictions import note_in_words
from workbook.lesson.prediction import Prediction
from workbook.lesson.prediction_views import Noted, PredictionOutcome, Waiting, show_buttons
from workbook.lesson.sealed_predictions import all_predictions

UNATTENDED = "WORKBOOK_UNATTENDED"
"""Environment variable, set while lessons are built or compared. No reader chooses then, so each outcome is shown."""

_known = cache(all_predictions)
_chosen: dict[str, str] = {}
_closed: dict[str, str | None] = {}
"""Predictions whose outcome this kernel has shown: the outcome's letter, or None if it fit no option."""
_waiting: dict[str, tuple[dict[str, object], Any]] = {}
"""Runs before the reader chose: their measurements, and the display handle that will show the outcome."""


def predict(name: str, choice: str | None = None, about: str | None = None) -> None:
    """Ask for a prediction, or note one: `predict("late-joiner", "b")`.

    With `about`, note a choice in the student's own words. Lessons that aren't converted yet use this.
    """
    if about is not None:
        note_in_words(name, about)
        return
    prediction = _find(name)
    if prediction is None:
        return
    if choice is None and unattended():
        print(_question(prediction))
        return
    drawn = asked()
    if drawn is not None and drawn.get("name") == name:
        clicked = drawn.get("choice") if choice is None else choice
        _show_choice(prediction, None if clicked is None else choose(prediction, str(clicked)))
    elif choice is not None:
        noted = choose(prediction, str(choice))
        print(noted.words)
        _show_choice(prediction, noted)
    else:
        show_buttons(prediction, _question(prediction), _chosen_letter(prediction), choose)


def reveal(name: str, **measured: object) -> None:
    """Show the choice, the outcome, and the explanations. The options' conditions refer to `measured`."""
    prediction = _find(name)
    if prediction is None:
        return
    mine = None if unattended() else _chosen_letter(prediction)
    if mine is None and not unattended():
        _waiting[name] = (measured, Waiting(prediction.letters).shown())
        return
    happened = prediction.decided_by(measured)
    _close(name, happened)
    PredictionOutcome(prediction, happened, mine, measured).shown()
    words = "" if mine is None else f"Your prediction: {mine}."
    show_prediction(name, mine, words, happened or prediction.usual)


def choose(prediction: Prediction, choice: str) -> Noted:
    """Note a choice, unless the outcome was already shown."""
    name = prediction.name
    letter, before = prediction.letter_of(choice), _chosen_letter(prediction)
    if letter is None:
        return Noted(before, f"{choice.strip()!r} isn't one of the options. Choose {prediction.letters}.")
    if before is not None and _is_closed(name):
        return Noted(
            before, f"Your prediction was {before}. You've seen the outcome, so you can't change it anymore."
        )
    _chosen[name] = letter
    note_prediction(name, letter)
    if name in _waiting:
        measured, place = _waiting.pop(name)
        happened = prediction.decided_by(measured)
        _close(name, happened)
        PredictionOutcome(prediction, happened, letter, measured).shown_at(place)
        return Noted(letter, f"Your prediction: {letter}. The outcome is shown below the cell that you ran.")
    return Noted(letter, f"Your prediction: {letter}. You can change it until you see the outcome.")


def unattended() -> bool:
    """Return whether lessons are being built or compared, so that no reader can choose."""
    return bool(os.environ.get(UNATTENDED))


def _find(name: str) -> Prediction | None:
    found = _known().get(name)
    if found is None:
        print(f"There is no prediction called {name!r}.")
    return found


def _question(prediction: Prediction) -> str:
    return f'Choose {prediction.letters}, with a button or by hand: predict("{prediction.name}", "…")'


def _chosen_letter(prediction: Prediction) -> str | None:
    letter = _chosen.get(prediction.name) or kept_choice(prediction.name)[0]
    return prediction.letter_of(letter) if letter else None


def _show_choice(prediction: Prediction, noted: Noted | None) -> None:
    """Have the front end's buttons show the current choice."""
    name = prediction.name
    letter = _chosen_letter(prediction) if noted is None else noted.letter
    words = "" if noted is None else noted.words
    outcome = (_closed.get(name) or prediction.usual) if letter and _is_closed(name) else None
    show_prediction(name, letter, words, outcome)


def _is_closed(name: str) -> bool:
    return name in _closed or kept_choice(name)[1]


def _close(name: str, happened: str | None) -> None:
    _closed[name] = happened
    _waiting.pop(name, None)
    note_outcome_seen(name)
