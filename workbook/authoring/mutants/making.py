"""Generate a program's mutants: apply every operator at every place and keep each distinct program once."""

import ast
import hashlib
import warnings
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from difflib import SequenceMatcher

import libcst as cst

from workbook.authoring.mutants import calls, conditions, literals, state, statements
from workbook.authoring.mutants.accepted import classes_of
from workbook.authoring.mutants.view import Edit, View
from workbook.exercise.answers import Answer

Operator = Callable[[cst.CSTNode, View], Iterator[Edit]]
OPERATORS: tuple[Operator, ...] = (
    literals.numbers,
    literals.texts,
    literals.booleans,
    conditions.comparisons,
    conditions.conditions,
    conditions.connectives,
    conditions.arithmetic,
    statements.drops,
    statements.early_returns,
    statements.loops,
    statements.exceptions,
    calls.near_calls,
    calls.unwrapped,
    calls.fewer_arguments,
    calls.swapped_arguments,
    state.forgetful_calls,
    state.lost_state,
    state.kept_results,
)
TYPED = (*OPERATORS, state.missing_hints)
"""The operators for exercises that are judged with a type checker. They also change type hints."""
ID_LENGTH = 10


@dataclass(frozen=True)
class Mutant:
    """A program with one fault. `base` names the right answer that it was made from: "solution" or "right/NAME.py".

    `id` depends on the operator, the changed lines, their scope, and `base`, but not on the line number. `classes` are
    the accepted classes that the mutant belongs to; see `accepted`.
    """

    id: str
    base: str
    operator: str
    scope: str
    line: int
    before: str
    after: str
    classes: tuple[str, ...]
    answer: Answer


def mutants_of(base: str, program: str, *, typed: bool = False) -> list[Mutant]:
    """Return a program's mutants from top to bottom.

    Leave out mutants that don't compile, or that differ from the program only in comments and layout. Raises
    libcst.ParserSyntaxError if the program isn't Python.
    """
    view = View(program)
    seen = {_meaning(program)}
    numbers: Counter[str] = Counter()
    found: list[Mutant] = []
    for edit in _edits(view, TYPED if typed else OPERATORS):
        changed = view.edited(edit)
        meaning = _meaning(changed)
        if meaning is None or meaning in seen:
            continue
        seen.add(meaning)
        before, after = changed_lines(program, changed)
        scope = view.scope(edit.old)
        key = "\n".join((base, edit.operator, scope, before, after))
        numbers[key] += 1
        digest = hashlib.sha256(f"{key}\n{numbers[key]}".encode()).hexdigest()[:ID_LENGTH]
        found.append(
            Mutant(
                digest,
                base,
                edit.operator,
                scope,
                view.line(edit.old),
                before,
                after,
                tuple(classes_of(edit, view)),
                Answer(changed),
            )
        )
    return found


def _edits(view: View, operators: tuple[Operator, ...]) -> Iterator[Edit]:
    for node in view.nodes():
        for operator in operators:
            yield from operator(node, view)


def _meaning(program: str) -> str | None:
    """Return a form of the program without comments and layout, or None if Python can't compile the program."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            tree = ast.parse(program)
            compile(tree, "answer.py", "exec", dont_inherit=True)
    except (SyntaxError, ValueError):
        return None
    return ast.dump(tree)


def changed_lines(before: str, after: str) -> tuple[str, str]:
    """Return the lines in which two programs differ, each side joined by `⏎` and without indentation.

    If lines were only added or only removed, both sides begin with the line above the change.
    """
    old, new = before.splitlines(), after.splitlines()
    matching = SequenceMatcher(None, old, new, autojunk=False)
    changes = [change for change in matching.get_opcodes() if change[0] != "equal"]
    removed = [line for _, begin, end, _, _ in changes for line in old[begin:end]]
    added = [line for _, _, _, begin, end in changes for line in new[begin:end]]
    if changes and not (removed and added):
        above = [line for line in old[: changes[0][1]] if line.strip()][-1:]
        removed, added = [*above, *removed], [*above, *added]
    return _folded(removed), _folded(added)


def _folded(lines: list[str]) -> str:
    return " ⏎ ".join(line.strip() for line in lines if line.strip())
