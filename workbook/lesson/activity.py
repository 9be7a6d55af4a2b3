"""Record a student's activity in a lesson for `%progress`: cells run, cells read, and predictions."""

import os
import time
from datetime import datetime
from pathlib import Path
from typing import Any

from workbook.exercise.source import STEM
from workbook.lesson.front_end import asked
from workbook.lesson.progress import changed_progress, load_progress

AT_LEAST_S = 2.0
"""A cell counts as read only if it was sent at least this long after the previous one. Reading takes longer; automatic
runs are faster.
"""
AT_ONCE_S = 0.5
"""Cells sent within this time of each other were sent together, even on a slow machine."""
BY_ITSELF_S = 0.2
"""In a Run All, some editors send each cell within this time after the previous one has finished. A person is slower.
"""


class StudyPace:
    """Distinguishes cells that a person runs one by one from the cells of a Run All.

    A cell counts as read if it was sent at least `AT_LEAST_S` after the previous cell, and not within `BY_ITSELF_S`
    after that cell finished. JupyterLab sends all cells of a Run All together; VS Code sends each cell when the
    previous one has finished. The first cell of a Run All looks as if a person ran it, so it's counted as read at
    first. If the next cell follows too soon, the first one no longer counts.
    """

    def __init__(self) -> None:
        self.counted: str | None = None
        """The last cell's ID if its last run made it count as read, or None otherwise."""
        self._sent: float | None = None
        self._ended = 0.0

    def takes_back(self, sent: float) -> str | None:
        """Return the ID of the last cell if it no longer counts as read, or None otherwise.

        It no longer counts if the next cell, which was sent at `sent`, followed too soon.
        """
        if self._sent is None:
            return None
        too_soon = sent - self._sent < AT_ONCE_S or 0 <= sent - self._ended < BY_ITSELF_S
        return self.counted if too_soon else None

    def step(self, sent: float) -> bool:
        """Return whether a person ran this cell by itself. Call this method after the cell, sent at `sent`, has run."""
        alone = self._sent is None or (
            sent - self._sent >= AT_LEAST_S and not 0 <= sent - self._ended < BY_ITSELF_S
        )
        self._sent, self._ended, self.counted = sent, time.time(), None
        return alone


_pace = StudyPace()


def lesson_stem() -> str | None:
    """Return the stem of the lesson that this kernel belongs to, as reported by Jupyter.

    The result is None for exercises and other notebooks. It's also None while notebooks are built or compared, so
    nothing is recorded then.
    """
    path = Path(os.environ.get("JPY_SESSION_NAME", ""))
    if path.suffix != ".ipynb" or path.parent.name != "notebooks" or not STEM.fullmatch(path.stem):
        return None
    return path.stem


def _sent_at() -> float:
    """Return the time (Unix timestamp, s) at which the front end sent the running cell.

    If that time is unknown, return the current time.
    """
    from IPython.core.getipython import get_ipython

    parent: object = getattr(get_ipython(), "get_parent", dict)()
    date = parent.get("header", {}).get("date") if isinstance(parent, dict) else None
    return date.timestamp() if isinstance(date, datetime) else time.time()


def note_prediction(about: str, choice: str) -> None:
    """Save the student's choice for the prediction or experiment named `about`. Outside of lessons, do nothing."""
    stem = lesson_stem()
    if stem is None:
        return
    try:
        with changed_progress(stem) as progress:
            progress.predictions[about] = choice
    except OSError:
        pass  # the folder isn't writable, so the lesson continues without saving the choice


def note_outcome_seen(name: str) -> None:
    """Record that a prediction's outcome was shown. Afterward, the student can't change the choice."""
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
    """Return the saved choice for a prediction, or None, and whether the prediction's outcome was shown."""
    stem = lesson_stem()
    if stem is None:
        return None, False
    progress = load_progress(stem)
    return progress.predictions.get(name), name in progress.outcomes_seen


def note_cell(result: Any, sent: float | None = None) -> None:
    """Record that a cell has run. IPython calls this function with the result after each cell.

    `sent`: the time at which the front end sent the cell, as a Unix timestamp in seconds. It defaults to the timestamp
    in the header of Jupyter's message.
    """
    stem = lesson_stem()
    cell = getattr(getattr(result, "info", None), "cell_id", None)
    if stem is None or not isinstance(cell, str):
        return
    if (drawn := asked()) is not None and "choice" in drawn:
        return  # a click on an option is saved as a prediction and doesn't count for the pace
    sent = _sent_at() if sent is None else sent
    not_read, is_read = _pace.takes_back(sent), _pace.step(sent)
    try:
        with changed_progress(stem) as progress:
            if cell not in progress.cells:
                progress.cells.append(cell)
            if not_read in progress.read:
                progress.read.remove(not_read)
            if is_read and cell not in progress.read:
                progress.read.append(cell)
                _pace.counted = cell
    except OSError:
        pass
