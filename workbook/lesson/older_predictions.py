"""Support lessons in the older format: predictions are free text, and the cell that recalls one has the outcome."""

from workbook.lesson.activity import note_prediction

_predictions: dict[str, str] = {}
_latest = ""


def note_in_words(choice: str, about: str) -> None:
    """Save a prediction: an option's letter or a few words. `about` names the experiment."""
    global _latest
    text = choice.strip()
    _latest = about
    if not text or set(text) <= {".", "?", "_", "…"}:
        _predictions.pop(about, None)
        print(f"No prediction for {about} yet. Put your choice between the quotes: predict('b')")
        return
    _predictions[about] = text
    note_prediction(about, text)
    print(f"Noted for {about}: {text}")


def predicted(about: str | None = None) -> str | None:
    """Return the prediction for an experiment, by default the latest, or None if there is none."""
    return _predictions.get(_latest if about is None else about)


def recall(right: str, about: str | None = None) -> None:
    """Print the prediction for an experiment, by default the latest, next to the outcome `right`.

    For example: `recall("c", "two timers")`.
    """
    name = _latest if about is None else about
    mine = _predictions.get(name)
    if mine is None:
        print(f"The outcome is {right}. (You made no prediction for {name}; try one next time.)")
    elif mine.casefold() == right.casefold():
        print(f"You predicted {mine} for {name}, and {right} it is.")
    else:
        print(f"You predicted {mine} for {name}; the run says {right}. Which belief has to change?")
