"""Ask for predictions before a run and show afterward whether they were right.

`predict("late-joiner")` asks and, after the run, `reveal("late-joiner", late=...)` shows the outcome. Until then, the
reader can change the choice. If the reader hasn't chosen, the outcome stays hidden.
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
"""The environment variable that is set while lessons are built or compared. No reader can choose then, so all outcomes
are shown.
"""

_known = cache(all_predictions)
_chosen: dict[str, str] = {}
_closed: dict[str, str | None] = {}
"""The outcomes that this kernel has shown: for each prediction, a letter, or None if the run didn't fit any option."""
_waiting: dict[str, tuple[dict[str, object], Any]] = {}
"""Runs that finished before the reader chose: for each prediction, the measurements and the display handle of the
placeholder that the outcome will replace.
"""


def predict(name: str, choice: str | None = None, about: str | None = None) -> None:
    """Ask for a prediction, or save one: `predict("late-joiner", "b")`.

    `name` is the prediction's name. Without `choice`, its options appear as buttons. In lessons of the older format,
    `name` is the choice itself, in your own words, and `about` names the experiment.
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
    """Show your choice, the outcome, and an explanation of each option.

    `measured`: the run's measurements, which decide the outcome. If you haven't chosen yet, everything appears once you
    choose.
    """
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
    """Save a choice, unless the outcome was already shown. Return the choice that counts, and a sentence about it."""
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
    """Update the front end's buttons with the current choice and, if the reader has seen it, the outcome."""
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
