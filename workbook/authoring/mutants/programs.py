"""Select the programs that an exercise's mutants are made from: the solution and two other right answers."""

import hashlib
from collections.abc import Mapping, Sequence
from difflib import SequenceMatcher
from functools import cache
from pathlib import Path

from workbook.authoring.mutants.making import Mutant, mutants_of
from workbook.authoring.tree import AuthoringError, Tree, entries
from workbook.exercise.answers import Answer, read_answer
from workbook.exercise.definition import Exercise

OTHERS = 2
SOLUTION = "solution"
MADE_BY = ("view", "literals", "conditions", "statements", "calls", "state", "making")


def right_programs(tree: Tree, exercise: Exercise, names: Sequence[str] = ()) -> dict[str, Answer]:
    """Return the solution and the right answers with these names, such as "one_timer.py".

    Without names, use the two right answers that are least similar to the solution. Raises AuthoringError if there is
    no right answer with a given name.
    """
    solution = Answer(exercise.source.solution_code)
    there = {
        path.name: read_answer(path, exercise.stem)
        for path in entries(tree.right_answers / exercise.stem)
        if path.suffix == ".py"
    }
    for name in names:
        if name not in there:
            raise AuthoringError(f"{exercise.stem} has no right answer {name!r}: {', '.join(there)}")
    chosen = names or sorted(there, key=lambda name: _likeness(solution, there[name]))[:OTHERS]
    return {SOLUTION: solution, **{f"right/{name}": there[name] for name in sorted(chosen)}}


def _likeness(one: Answer, other: Answer) -> float:
    return SequenceMatcher(None, one.text.splitlines(), other.text.splitlines(), autojunk=False).ratio()


def all_mutants(exercise: Exercise, programs: Mapping[str, Answer]) -> list[Mutant]:
    """Return the mutants of all programs. For a statically judged exercise, include mutants of type hints."""
    typed = exercise.source.kind == "static"
    return [one for base, answer in programs.items() for one in mutants_of(base, answer.text, typed=typed)]


def inputs_of(exercise: Exercise, programs: Mapping[str, Answer]) -> dict[str, str]:
    """Return the hashes of a report's inputs, keyed by name: the criteria, the operators, and each program."""
    return {
        "criteria": exercise.criteria_sha256,
        "operators": operators_sha256(),
        **{name: one.sha256 for name, one in programs.items()},
    }


@cache
def operators_sha256() -> str:
    """Return a hash of the code that generates mutants."""
    digest = hashlib.sha256()
    for name in MADE_BY:
        digest.update(Path(__file__).with_name(f"{name}.py").read_bytes())
    return digest.hexdigest()
