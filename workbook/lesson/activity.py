"""A student's activity in a lesson, noted for `%progress`: the cells run and the predictions made."""

import os
from pathlib import Path
from typing import Any

from workbook.exercise.source import STEM
from workbook.lesson.progress import changed_progress, load_progress

_noted_cells: set[str] = set()


def lesson_stem() -> str | None:
    """The lesson that this kernel belongs to, as far as Jupyter says; None for exercises and other notebooks.

    Nothing is noted while notebooks are built or compared: there is no name then.
    """
    path = Path(os.environ.get("JPY_SESSION_NAME", ""))
    if path.suffix != ".ipynb" or path.parent.name != "notebooks" or not STEM.fullmatch(path.stem):
        return None
    return path.stem


def note_prediction(about: str, choice: str) -> None:
    """Note the option chosen for the experiment `about`; does nothing outside of lessons."""
    stem = lesson_stem()
    if stem is None:
        return
    try:
        with changed_progress(stem) as progress:
            progress.predictions[about] = choice
    except OSError:
        pass  # a folder that cannot be written: the lesson goes on without notes


def note_outcome_seen(name: str) -> None:
    """Note that the outcome of a prediction was shown: the choice stays from now on."""
    stem = lesson_stem()
    if stem is None:
        return
    try:
        with changed_progress(stem) as progress:
            if name not in progress.outcomes_seen:
                progress.outcomes_seen.append(name)
    except OSError:
        pass


def kept_choice(name: str) -> tuple[str | None, bool]:
    """The option chosen for a prediction, in this kernel or before, and whether its outcome was shown."""
    stem = lesson_stem()
    if stem is None:
        return None, False
    progress = load_progress(stem)
    return progress.predictions.get(name), name in progress.outcomes_seen


def note_cell(result: Any) -> None:
    """Note that a cell has run. IPython calls this with the result after each cell."""
    stem = lesson_stem()
    cell = getattr(getattr(result, "info", None), "cell_id", None)
    if stem is None or not isinstance(cell, str) or cell in _noted_cells:
        return
    _noted_cells.add(cell)
    try:
        with changed_progress(stem) as progress:
            if cell not in progress.cells:
                progress.cells.append(cell)
    except OSError:
        pass
