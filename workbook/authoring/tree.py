"""The course's folders, and the stems of its lessons and exercises."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from workbook.exercise.source import DEEPER, STEM

IGNORED_NAMES = ("__pycache__",)
"""Folders that tools leave behind. Names that begin with a dot are also ignored."""


class AuthoringError(RuntimeError):
    """Raised when a lesson, exercise, or page can't be built or checked. The message says what to fix, and where."""


@dataclass(frozen=True)
class Tree:
    """A checkout of the course. `root` is its folder."""

    root: Path

    @property
    def notebooks(self) -> Path:
        """The folder of the built lessons."""
        return self.root / "notebooks"

    @property
    def sources(self) -> Path:
        """The folder of the lesson texts, one percent script per lesson."""
        return self.notebooks / "sources"

    @property
    def museum(self) -> Path:
        """The folder for the error museum and the glossary, which contains one TOML file per lesson."""
        return self.sources / "museum"

    @property
    def sealed(self) -> Path:
        """The folder with the sealed (encoded) predictions, one file for each lesson that has predictions."""
        return self.root / "workbook" / "lesson" / "sealed"

    @property
    def exercises(self) -> Path:
        """The folder for the built exercise notebooks, which contain the starter code."""
        return self.root / "exercises"

    @property
    def criteria(self) -> Path:
        """The folder of the criteria files, one per exercise."""
        return self.exercises / "criteria"

    @property
    def drivers(self) -> Path:
        """The folder for drivers, which are programs that call an answer's functions, for exercises that need one."""
        return self.exercises / "drivers"

    @property
    def partners(self) -> Path:
        """The folder of the nodes that run next to a started answer, for exercises whose node needs other nodes."""
        return self.exercises / "partners"

    @property
    def solutions(self) -> Path:
        """The folder of the exercise sources: one file per exercise with the text, the starter, and the solution."""
        return self.root / "solutions"

    @property
    def right_answers(self) -> Path:
        """The folder of other programs that must get full marks. It has one subfolder per exercise."""
        return self.root / "tests" / "right_answers"

    @property
    def wrong_answers(self) -> Path:
        """The folder of programs with one mistake each, which must lose points. It has one subfolder per exercise."""
        return self.root / "tests" / "wrong_answers"

    @property
    def requirements(self) -> Path:
        """The folder of the tables that link each requirement of a task to its criteria, one TOML file per exercise."""
        return self.root / "tests" / "requirements"

    @property
    def mutants(self) -> Path:
        """The folder with the mutant reports, one TOML file per exercise; see `workbook.authoring.mutants`."""
        return self.root / "tests" / "mutants"

    @property
    def lesson_nodes(self) -> Path:
        """The folder of the ROS nodes that lessons import or run."""
        return self.root / "lesson_nodes"

    @property
    def solved(self) -> Path:
        """The folder of exercise notebooks with the solution filled in. They're built when needed, and not in git."""
        return self.root / "build" / "solved"

    def lesson_stems(self) -> tuple[str, ...]:
        """Return the stem (NN_slug) of every lesson that has a text, sorted."""
        return stems_in(self.sources, ".py")

    def main_stems(self) -> tuple[str, ...]:
        """Return the stems of the main lessons, without the deeper notebooks."""
        return tuple(stem for stem in self.lesson_stems() if not stem.endswith(DEEPER))

    def deeper_stem(self, stem: str) -> str | None:
        """Return the stem of a lesson's optional deeper notebook, or None if there is none."""
        deeper = f"{stem}{DEEPER}"
        return deeper if deeper in self.lesson_stems() else None

    def exercise_stems(self) -> tuple[str, ...]:
        """Return the sorted stems (NN_slug) of all exercises that have a source."""
        return stems_in(self.solutions, ".py")

    def name(self, path: Path) -> str:
        """Return a path for messages: relative to the course if it's inside, otherwise unchanged."""
        return path.relative_to(self.root).as_posix() if path.is_relative_to(self.root) else str(path)


def stems_in(folder: Path, suffix: str) -> tuple[str, ...]:
    """Return the sorted stems of a folder's files that are named NN_slug and end in `suffix`."""
    return tuple(sorted(path.stem for path in folder.glob(f"*{suffix}") if STEM.fullmatch(path.stem)))


def entries(folder: Path) -> Iterator[Path]:
    """Yield a folder's sorted entries, except those that tools leave behind. A missing folder has no entries."""
    if not folder.is_dir():
        return
    for path in sorted(folder.iterdir()):
        if not path.name.startswith(".") and path.name not in IGNORED_NAMES:
            yield path
