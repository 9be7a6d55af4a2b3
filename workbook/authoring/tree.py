"""The folders of the course, and which files belong in them."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from workbook.exercise.source import STEM

IGNORED_NAMES = ("__pycache__",)
"""Left by tools. Names that begin with a dot are ignored as well."""


class AuthoringError(RuntimeError):
    """A lesson or an exercise cannot be built. The message says what to mend, and where."""


@dataclass(frozen=True)
class Tree:
    """A checkout of the course."""

    root: Path

    @property
    def notebooks(self) -> Path:
        return self.root / "notebooks"

    @property
    def sources(self) -> Path:
        return self.notebooks / "sources"

    @property
    def museum(self) -> Path:
        return self.sources / "museum"

    @property
    def exercises(self) -> Path:
        return self.root / "exercises"

    @property
    def criteria(self) -> Path:
        return self.exercises / "criteria"

    @property
    def drivers(self) -> Path:
        return self.exercises / "drivers"

    @property
    def solutions(self) -> Path:
        return self.root / "solutions"

    @property
    def right_answers(self) -> Path:
        return self.root / "tests" / "right_answers"

    @property
    def wrong_answers(self) -> Path:
        return self.root / "tests" / "wrong_answers"

    @property
    def lesson_nodes(self) -> Path:
        return self.root / "lesson_nodes"

    @property
    def solved(self) -> Path:
        """Exercise notebooks with the solution put in: built when needed, not in git."""
        return self.root / "build" / "solved"

    def lesson_stems(self) -> tuple[str, ...]:
        return stems_in(self.sources, ".py")

    def exercise_stems(self) -> tuple[str, ...]:
        return stems_in(self.solutions, ".py")

    def name(self, path: Path) -> str:
        """The path as it is shown: relative to the course."""
        return path.relative_to(self.root).as_posix() if path.is_relative_to(self.root) else str(path)


def stems_in(folder: Path, suffix: str) -> tuple[str, ...]:
    """Stems of the form NN_slug of all files with this suffix, sorted."""
    return tuple(sorted(path.stem for path in folder.glob(f"*{suffix}") if STEM.fullmatch(path.stem)))


def entries(folder: Path) -> Iterator[Path]:
    """What lies in a folder (nothing if there is none), without what tools leave behind."""
    if not folder.is_dir():
        return
    for path in sorted(folder.iterdir()):
        if not path.name.startswith(".") and path.name not in IGNORED_NAMES:
            yield path
