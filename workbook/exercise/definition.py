"""Define an exercise as the judge uses it: its criteria, its plan, and its text.

The *plan* says how long to watch a program, which endpoints to wait for, and which messages to send.
"""

import hashlib
import importlib.util
import os
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from types import ModuleType
from typing import Any

from workbook.criteria.criterion import (
    Criterion,
    Watching,
    criteria_in,
    plan_for,
    topics_in,
    watching_in,
)
from workbook.criteria.rules import refuse_leftovers
from workbook.criteria.vocabulary.type_checks import probes_in
from workbook.exercise.course import course_folder
from workbook.exercise.judged_numbers import with_judged_numbers
from workbook.exercise.source import ExerciseSource, driver_of, find, load
from workbook.recording.plan import Plan

OWN_CRITERIA = "WORKBOOK_CRITERIA"
"""The environment variable for a folder outside the course with an instructor's own criteria, `NN_slug.py`."""

FIRST_SEED = 0
"""The script's seed until a run draws another one, so that the script's topics and services are known before a run."""


class BrokenCriteria(RuntimeError):
    """Raised when an exercise's criteria can't be used. The message says why."""


def _import(path: Path) -> ModuleType:
    name = f"workbook_criteria_{path.stem}"
    spec = importlib.util.spec_from_file_location(name, path)
    if spec is None or spec.loader is None:
        raise BrokenCriteria(f"{path} is not a Python file")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    try:
        spec.loader.exec_module(module)
        refuse_leftovers(module)
    except Exception as error:
        raise BrokenCriteria(f"{path}: {error!r}") from error
    return module


@dataclass(frozen=True)
class Exercise:
    """One exercise as the judge uses it.

    `criteria` are in order, `plan` says how to watch a program for them, and `periods` are the judged periods (s) by
    topic. `to_the_end`: whether the way in which the program exits is judged, too. `driver`: the program that calls an
    answer's functions, if the answer isn't a program. `probes`: snippets that use an answer, by name, which the type
    checker checks along with the answer. `watching`: the settings that the plan was made from. `signed`: the topics on
    which only messages signed by the driver count. `constants`: the criteria file's constants with uppercase names.
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
    signed: tuple[str, ...] = ()
    constants: Mapping[str, Any] = field(default_factory=dict)

    @cached_property
    def source(self) -> ExerciseSource:
        """The title, task, hints, starter, and solution. The task states the judge's numbers."""
        return with_judged_numbers(load(self.solution_path), {**self.constants, "plan": self.plan})

    @property
    def max_points(self) -> float:
        """The points for all criteria, including hidden ones."""
        return sum(criterion.points for criterion in self.criteria)

    def drawn(self, seed: int) -> "Exercise":
        """Return the exercise with the script for one run, drawn from `seed`.

        Return the exercise itself if its script is fixed.
        """
        plan = self.watching.drawn(self.plan, seed)
        return self if plan is self.plan else replace(self, plan=plan)


def load_exercise(name: str, course: Path | None = None) -> Exercise:
    """Load an exercise by stem ("09_joint_positions") or slug ("joint_positions").

    Raises UnknownExercise if there is no such exercise, and BrokenCriteria if its criteria can't be imported.
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
    files = [path, *_words_of(path), *(() if driver is None else (driver,))]
    topics, how = topics_in(module), watching_in(module)
    own = own_criteria(solution.stem)
    if own is not None:
        more = _import(own)
        criteria += tuple(replace(one, hidden=True) for one in criteria_in(more))
        topics += tuple(one for one in topics_in(more) if one.name not in {known.name for known in topics})
        files += [own, *_words_of(own)]
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
        signed=tuple(one.name for one in topics if one.signed),
        constants={name: value for name, value in vars(module).items() if name.isupper()},
    )


def own_criteria(stem: str) -> Path | None:
    """Return the path of the instructor's own criteria for this exercise, or None if there are none.

    These criteria are kept outside the course and are always hidden.
    """
    folder = os.environ.get(OWN_CRITERIA)
    path = Path(folder) / f"{stem}.py" if folder else None
    return path if path is not None and path.is_file() else None


def _words_of(criteria: Path) -> list[Path]:
    path = criteria.with_suffix(".toml")
    return [path] if path.is_file() else []


def _sum_of(files: Sequence[Path]) -> str:
    """Return the hash of these files: the ones that affect a judgment, including the driver, if any."""
    digest = hashlib.sha256()
    for path in files:
        digest.update(path.read_bytes())
    return digest.hexdigest()
