"""A student's activity in a lesson, noted for `%progress`: the cells run, which of them one by one, the predictions."""

import os
import time
from datetime import datetime
from pathlib import Path
from typing import Any

from workbook.exercise.source import STEM
from workbook.lesson.progress import changed_progress, load_progress

AT_LEAST_S = 2.0
"""Between two cells that somebody reads. Slower than any automatic run, and quicker than anybody reads."""
AT_ONCE_S = 0.5
"""Cells that are sent within this time of each other were sent together, on a slow machine, too."""
BY_ITSELF_S = 0.2
"""Editors that send the next cell of a Run All when the last has ended do so within this time; a person does not."""


class StudyPace:
    """Tells cells that a person runs one by one from those of a Run All.

    A cell counts as read when it was sent at least `AT_LEAST_S` after the one before, and not in the instant after that
    had ended. JupyterLab sends all cells of a Run All at once, VS Code each when the last has ended. The first cell of
    a Run All looks like one that was run alone: it is taken back when the next one comes too soon.
    """

    def __init__(self) -> None:
        self.counted: str | None = None
        """The last cell, if it was that run of it that made it count."""
        self._sent: float | None = None
        self._ended = 0.0

    def takes_back(self, sent: float) -> str | None:
        """The last cell, if it was that run that made it count, and the next one came too soon after it."""
        if self._sent is None:
            return None
        too_soon = sent - self._sent < AT_ONCE_S or 0 <= sent - self._ended < BY_ITSELF_S
        return self.counted if too_soon else None

    def step(self, sent: float) -> bool:
        """Whether the cell sent at `sent`, which has just ended, was run alone."""
        alone = self._sent is None or (
            sent - self._sent >= AT_LEAST_S and not 0 <= sent - self._ended < BY_ITSELF_S
        )
        self._sent, self._ended, self.counted = sent, time.time(), None
        return alone


_pace = StudyPace()


def lesson_stem() -> str | None:
    """The lesson that this kernel belongs to, as far as Jupyter says; None for exercises and other notebooks.

    Nothing is noted while notebooks are built or compared: there is no name then.
    """
    path = Path(os.environ.get("JPY_SESSION_NAME", ""))
    if path.suffix != ".ipynb" or path.parent.name != "notebooks" or not STEM.fullmatch(path.stem):
        return None
    return path.stem


def _sent_at() -> float:
    """When the front end sent the cell that is running; now where it does not say."""
    from IPython.core.getipython import get_ipython

    parent: object = getattr(get_ipython(), "get_parent", dict)()
    date = parent.get("header", {}).get("date") if isinstance(parent, dict) else None
    return date.timestamp() if isinstance(date, datetime) else time.time()


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


def note_cell(result: Any, sent: float | None = None) -> None:
    """Note that a cell has run. IPython calls this with the result after each cell.

    `sent`: when the front end asked for it (seconds since 1970); by default, what Jupyter's message says.
    """
    stem = lesson_stem()
    cell = getattr(getattr(result, "info", None), "cell_id", None)
    if stem is None or not isinstance(cell, str):
        return
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
