"""What a student has done so far, in a small file of their work folder: tries, hints seen, solved."""

import json
from dataclasses import asdict, dataclass
from pathlib import Path

from workbook.magics.answers import answers_folder

TRIES_BEFORE_SOLUTION = 5


@dataclass
class ExerciseProgress:
    """One exercise: judged tries, hints shown, and whether it ever got full marks."""

    tries: int = 0
    hints: int = 0
    solved: bool = False
    best: float = 0.0

    @property
    def may_see_solution(self) -> bool:
        return self.solved or self.tries >= TRIES_BEFORE_SOLUTION


def _file() -> Path:
    return answers_folder() / ".progress.json"


def load_progress(stem: str) -> ExerciseProgress:
    try:
        data = json.loads(_file().read_text())[stem]
        return ExerciseProgress(**data)
    except (OSError, ValueError, KeyError, TypeError):
        return ExerciseProgress()


def save_progress(stem: str, progress: ExerciseProgress) -> None:
    path = _file()
    path.parent.mkdir(parents=True, exist_ok=True)
    try:
        data = json.loads(path.read_text())
    except (OSError, ValueError):
        data = {}
    if not isinstance(data, dict):
        data = {}
    data[stem] = asdict(progress)
    partial = path.with_suffix(".part")
    partial.write_text(json.dumps(data, indent=1, sort_keys=True))
    partial.replace(path)
