"""An exercise as the judge needs it: its criteria, what to watch, and its text."""

import hashlib
import importlib.util
import os
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from types import ModuleType

from workbook.criteria.criterion import (
    Criterion,
    Watching,
    criteria_in,
    plan_for,
    topics_in,
    watching_in,
)
from workbook.criteria.vocabulary.type_checks import probes_in
from workbook.exercise.course import course_folder
from workbook.exercise.source import ExerciseSource, driver_of, find, load
from workbook.recording.plan import Plan

OWN_CRITERIA = "WORKBOOK_CRITERIA"
"""Variable that names a folder with an instructor's own criteria, `NN_slug.py`, outside of the course."""

FIRST_SEED = 0
"""What a script is drawn from as long as no run has drawn its own: then its topics and services are known."""


class BrokenCriteria(RuntimeError):
    """The criteria of an exercise cannot be used. The message says why."""


def _import(path: Path) -> ModuleType:
    name = f"workbook_criteria_{path.stem}"
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise BrokenCriteria(f"{path} is not a Python file")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    try:
        spec.loader.exec_module(module)
    except Exception as error:
        raise BrokenCriteria(f"{path}: {error!r}") from error
    return module


@dataclass(frozen=True)
class Exercise:
    """One exercise as the judge needs it.

    `criteria` are in order, `plan` is the watch that they need, and `periods` are the judged periods (s) by topic.
    `to_the_end`: the program's end is judged as well. `driver`: what calls the functions of an answer that is no
    program. `probes`: by name, code that uses an answer and is read by the type checker together with it. `watching`:
    what the plan was made of.
    """

    stem: str
    criteria: tuple[Criterion, ...]
    plan: Plan
    periods: Mapping[str, float]
    to_the_end: bool
    criteria_sha256: str
    solution_path: Path
    driver: Path | None = None
    probes: Mapping[str, str] = field(default_factory=dict)
    watching: Watching = field(default_factory=Watching)

    @cached_property
    def source(self) -> ExerciseSource:
        """Title, hints, starter and solution."""
        return load(self.solution_path)

    @property
    def max_points(self) -> float:
        """The sum of all criteria, hidden ones included."""
        return sum(criterion.points for criterion in self.criteria)

    def drawn(self, seed: int) -> "Exercise":
        """The exercise with the script of one run, drawn from `seed`; itself if its script is the same in each."""
        plan = self.watching.drawn(self.plan, seed)
        return self if plan is self.plan else replace(self, plan=plan)


def load_exercise(name: str, course: Path | None = None) -> Exercise:
    """Find an exercise by stem ("09_joint_positions") or slug ("joint_positions").

    Raises UnknownExercise when there is none of this name, BrokenCriteria when its criteria do not import.
    """
    folder = course_folder() if course is None else course
    solution = find(folder / "solutions", name)
    path = folder / "exercises" / "criteria" / f"{solution.stem}.py"
    if not path.is_file():
        raise BrokenCriteria(f"{solution.stem} has no criteria: {path} is missing")
    module = _import(path)
    criteria = criteria_in(module)
    if not criteria:
        raise BrokenCriteria(f"{path} defines no criterion")
    try:
        probes = probes_in(module)
    except ValueError as error:
        raise BrokenCriteria(f"{path}: {error}") from error
    driver = driver_of(solution)
    files = [path] if driver is None else [path, driver]
    topics, how = topics_in(module), watching_in(module)
    own = own_criteria(solution.stem)
    if own is not None:
        more = _import(own)
        criteria += tuple(replace(one, hidden=True) for one in criteria_in(more))
        topics += tuple(one for one in topics_in(more) if one.name not in {known.name for known in topics})
        files.append(own)
    try:
        plan = how.drawn(plan_for(topics, how), FIRST_SEED)
    except Exception as error:
        raise BrokenCriteria(f"{path}: its script cannot be drawn: {error!r}") from error
    return Exercise(
        stem=solution.stem,
        criteria=criteria,
        plan=plan,
        to_the_end=how.to_the_end,
        periods={one.name: one.period for one in topics if one.hz is not None},
        criteria_sha256=_sum_of(files),
        solution_path=solution,
        driver=driver,
        probes=probes,
        watching=how,
    )


def own_criteria(stem: str) -> Path | None:
    """The instructor's own criteria for this exercise, kept outside of the course. They are always hidden."""
    folder = os.environ.get(OWN_CRITERIA)
    path = Path(folder) / f"{stem}.py" if folder else None
    return path if path is not None and path.is_file() else None


def _sum_of(files: Sequence[Path]) -> str:
    """What the judgement depends on: another driver is another exercise."""
    digest = hashlib.sha256()
    for path in files:
        digest.update(path.read_bytes())
    return digest.hexdigest()
