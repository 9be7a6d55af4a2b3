"""Predictions: say what will happen before you run it, and see afterwards whether it did.

`predict("late-joiner")` asks, `reveal("late-joiner", late=...)` in the run answers. A choice may be changed until the
run has revealed the outcome. Nothing is revealed to a reader who has not chosen.
"""

import os
from functools import cache
from typing import Any

from workbook.lesson.activity import kept_choice, note_outcome_seen, note_prediction
from workbook.lesson.older_predictions import note_in_words
from workbook.lesson.prediction import Prediction
from workbook.lesson.prediction_views import Noted, PredictionOutcome, Waiting, show_buttons
from workbook.lesson.sealed_predictions import all_predictions

UNATTENDED = "WORKBOOK_UNATTENDED"
"""Environment variable: lessons are built or compared. Nobody chooses, and each outcome is shown."""

_known = cache(all_predictions)
_chosen: dict[str, str] = {}
_closed: set[str] = set()
_waiting: dict[str, tuple[dict[str, object], Any]] = {}
"""Runs that came before the choice: what they measured, and the place that is to show the outcome."""


def predict(name: str, choice: str | None = None, about: str | None = None) -> None:
    """Ask for a prediction, or note one: `predict("late-joiner", "b")`.

    With `about`, it notes a choice in the student's own words, as lessons that are not converted yet do.
    """
    if about is not None:
        note_in_words(name, about)
        return
    prediction = _find(name)
    if prediction is None:
        return
    if choice is not None:
        print(choose(prediction, str(choice)).words)
    elif unattended():
        print(_question(prediction))
    else:
        show_buttons(prediction, _question(prediction), _chosen_letter(prediction), choose)


def reveal(name: str, **measured: object) -> None:
    """Show the choice, what happened and why. `measured` is what the run decides by."""
    prediction = _find(name)
    if prediction is None:
        return
    mine = None if unattended() else _chosen_letter(prediction)
    if mine is None and not unattended():
        _waiting[name] = (measured, Waiting(prediction.letters).shown())
        return
    _close(name)
    PredictionOutcome(prediction, prediction.decided_by(measured), mine, measured).shown()


def choose(prediction: Prediction, choice: str) -> Noted:
    """Note a choice, unless the outcome was shown before."""
    name = prediction.name
    letter, before = prediction.letter_of(choice), _chosen_letter(prediction)
    if letter is None:
        return Noted(before, f"{choice.strip()!r} is none of the options. Choose {prediction.letters}.")
    if before is not None and _is_closed(name):
        return Noted(before, f"Your prediction was {before}. You have seen the outcome, so it stays.")
    _chosen[name] = letter
    note_prediction(name, letter)
    if name in _waiting:
        measured, place = _waiting.pop(name)
        _close(name)
        PredictionOutcome(prediction, prediction.decided_by(measured), letter, measured).shown_at(place)
        return Noted(letter, f"Your prediction: {letter}. The outcome is shown below the cell that you ran.")
    return Noted(letter, f"Your prediction: {letter}. You can change it until you see the outcome.")


def unattended() -> bool:
    """Whether lessons are being built or compared, and nobody is there to choose."""
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


def _is_closed(name: str) -> bool:
    return name in _closed or kept_choice(name)[1]


def _close(name: str) -> None:
    _closed.add(name)
    _waiting.pop(name, None)
    note_outcome_seen(name)
