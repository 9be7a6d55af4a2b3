"""The folders of the course, and which files belong in them."""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from workbook.exercise.source import DEEPER, STEM

IGNORED_NAMES = ("__pycache__",)
"""Left by tools. Names that begin with a dot are ignored as well."""


class AuthoringError(RuntimeError):
    """A lesson or an exercise cannot be built. The message says what to fix, and where."""


@dataclass(frozen=True)
class Tree:
    """A checkout of the course."""

    root: Path

    @property
    def notebooks(self) -> Path:
        """Folder of the built lessons."""
        return self.root / "notebooks"

    @property
    def sources(self) -> Path:
        """Folder of the lesson texts, one percent script per lesson."""
        return self.notebooks / "sources"

    @property
    def museum(self) -> Path:
        """Folder of the error museum and the glossary, one TOML file per lesson."""
        return self.sources / "museum"

    @property
    def sealed(self) -> Path:
        """Folder of what predictions reveal after the run, one encoded file per lesson that has predictions."""
        return self.root / "workbook" / "lesson" / "sealed"

    @property
    def exercises(self) -> Path:
        """Folder of the built exercise notebooks, which hold the starter."""
        return self.root / "exercises"

    @property
    def criteria(self) -> Path:
        """Folder of the criteria files, one per exercise."""
        return self.exercises / "criteria"

    @property
    def drivers(self) -> Path:
        """Folder of the programs that call the functions of an answer, for exercises that need one."""
        return self.exercises / "drivers"

    @property
    def solutions(self) -> Path:
        """Folder of the exercise sources: text, starter and reference answer in one file."""
        return self.root / "solutions"

    @property
    def right_answers(self) -> Path:
        """Folder of further programs that must get full marks, one folder per exercise."""
        return self.root / "tests" / "right_answers"

    @property
    def wrong_answers(self) -> Path:
        """Folder of programs with one mistake each, which must lose the points they name, one folder per exercise."""
        return self.root / "tests" / "wrong_answers"

    @property
    def requirements(self) -> Path:
        """Folder of the tables that tie each demand of a task to what judges it, one TOML file per exercise."""
        return self.root / "tests" / "requirements"

    @property
    def mutants(self) -> Path:
        """Reports on what the judges let through; see `workbook.authoring.mutants`."""
        return self.root / "tests" / "mutants"

    @property
    def lesson_nodes(self) -> Path:
        """Folder of the ROS nodes that lessons import or run."""
        return self.root / "lesson_nodes"

    @property
    def solved(self) -> Path:
        """Exercise notebooks with the solution put in: built when needed, not in git."""
        return self.root / "build" / "solved"

    def lesson_stems(self) -> tuple[str, ...]:
        """The stem (NN_slug) of every lesson that has a text, sorted."""
        return stems_in(self.sources, ".py")

    def main_stems(self) -> tuple[str, ...]:
        """The stems of the lessons that everybody takes, without the deeper notebooks beside them."""
        return tuple(stem for stem in self.lesson_stems() if not stem.endswith(DEEPER))

    def deeper_stem(self, stem: str) -> str | None:
        """The stem of the optional notebook that goes deeper than this lesson, if there is one."""
        deeper = f"{stem}{DEEPER}"
        return deeper if deeper in self.lesson_stems() else None

    def exercise_stems(self) -> tuple[str, ...]:
        """The stem (NN_slug) of every exercise that has a source, sorted."""
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
