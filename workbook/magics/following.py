"""Notes which cells of a lesson a student runs, and what they predict, for `%progress`."""

import os
from pathlib import Path
from typing import Any

from workbook.exercise.source import STEM
from workbook.magics.progress import changed_progress

_noted: set[str] = set()


def lesson_stem() -> str | None:
    """The lesson that this kernel belongs to, as far as Jupyter tells; None for exercises and other notebooks.

    Nothing is noted while notebooks are built or compared: there is no name then.
    """
    path = Path(os.environ.get("JPY_SESSION_NAME", ""))
    if path.suffix != ".ipynb" or path.parent.name != "notebooks" or not STEM.fullmatch(path.stem):
        return None
    return path.stem


def note_prediction(about: str, choice: str) -> None:
    """Keep a prediction."""
    stem = lesson_stem()
    if stem is None:
        return
    try:
        with changed_progress(stem) as progress:
            progress.predictions[about] = choice
    except OSError:
        pass  # a read-only folder: the lesson goes on without


def note_cell(result: Any) -> None:
    """After a cell has run: keep its id, once."""
    stem = lesson_stem()
    cell = getattr(getattr(result, "info", None), "cell_id", None)
    if stem is None or not isinstance(cell, str) or cell in _noted:
        return
    _noted.add(cell)
    try:
        with changed_progress(stem) as progress:
            if cell not in progress.cells:
                progress.cells.append(cell)
    except OSError:
        pass
