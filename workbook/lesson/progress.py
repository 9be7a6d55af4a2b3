"""Save a student's progress in a small file in the work folder: cells, predictions, tries, and points."""

import fcntl
import json
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field, fields
from pathlib import Path
from typing import Any

from workbook.exercise.answer_files import answers_folder

TRIES_BEFORE_SOLUTION = 5
"""The number of judged tries after which a student may see the solution: enough to use the three hints one by one."""


@dataclass
class LessonProgress:
    """A student's progress in a lesson and its exercise.

    `cells`: the IDs of code cells that were run. `read`: the IDs of those that were run one by one, according to
    `activity`. `predictions`: the choices, keyed by prediction or experiment. `outcomes_seen`: the predictions that can
    no longer be changed. `touched`: the time of the last save, as a Unix timestamp in seconds. The other fields
    describe the exercise: judged tries, hints shown, whether it ever got full marks, and the most points.
    """

    tries: int = 0
    hints: int = 0
    solved: bool = False
    best: float = 0.0
    touched: float = 0.0
    cells: list[str] = field(default_factory=list)
    read: list[str] = field(default_factory=list)
    predictions: dict[str, str] = field(default_factory=dict)
    outcomes_seen: list[str] = field(default_factory=list)

    @property
    def may_see_solution(self) -> bool:
        """Whether `%solution` shows the reference answer."""
        return self.solved or self.tries >= TRIES_BEFORE_SOLUTION


_KNOWN = {
    one.name: type(one.default_factory() if callable(one.default_factory) else one.default)
    for one in fields(LessonProgress)
}


def progress_file(folder: Path | None = None) -> Path:
    """Return the path of the progress file, in the folder of answers."""
    return (folder or answers_folder()) / ".progress.json"


def all_progress(folder: Path | None = None) -> dict[str, LessonProgress]:
    """Load all progress saved in a folder of answers, keyed by stem. Damaged entries count as empty."""
    return {stem: _read(entry) for stem, entry in _stored(folder).items()}


def load_progress(stem: str) -> LessonProgress:
    """Load the saved progress for a lesson and its exercise. If nothing was saved, the progress is empty."""
    return _read(_stored().get(stem))


def save_progress(stem: str, progress: LessonProgress) -> None:
    """Replace a lesson's saved progress."""
    with _locked():
        _write(stem, progress)


@contextmanager
def changed_progress(stem: str) -> Iterator[LessonProgress]:
    """Lock a lesson's saved progress, yield it for changes, and save it. Several notebooks may do so in parallel."""
    with _locked():
        progress = load_progress(stem)
        before = asdict(progress)
        yield progress
        if asdict(progress) != before:
            progress.touched = time.time()
            _write(stem, progress)


@contextmanager
def _locked() -> Iterator[None]:
    path = progress_file()
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.with_name(".progress.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def _stored(folder: Path | None = None) -> dict[str, Any]:
    try:
        data = json.loads(progress_file(folder).read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return data if isinstance(data, dict) else {}


def _read(entry: object) -> LessonProgress:
    """Convert a saved entry, which another version of the course may have written. Ignore unknown or invalid fields."""
    if not isinstance(entry, dict):
        return LessonProgress()
    known = {
        name: entry[name]
        for name, kind in _KNOWN.items()
        if isinstance(entry.get(name), (int, float) if kind is float else kind)
    }
    return LessonProgress(**known)


def _write(stem: str, progress: LessonProgress) -> None:
    data = _stored()
    entry = data.get(stem)
    data[stem] = {**(entry if isinstance(entry, dict) else {}), **asdict(progress)}
    path = progress_file()
    partial = path.with_suffix(".part")
    partial.write_text(json.dumps(data, indent=1, sort_keys=True, ensure_ascii=False), encoding="utf-8")
    partial.replace(path)
