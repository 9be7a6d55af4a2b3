"""Split a lesson's predictions into the part that the notebook shows, and the rest, which is sealed (encoded).

A Markdown cell with `prediction="late-joiner"` contains the question and its options. The explanation below an option
begins with ✓ (the usual outcome) or ✗. If the outcome depends on the run, a condition follows: ``when `late > 0` ``.
"""

import ast
import re
from collections.abc import Iterator, Sequence

from workbook.authoring.document import Cell, Document, write
from workbook.authoring.marks import marks_in_prediction
from workbook.authoring.tree import Tree, entries
from workbook.authoring.violations import Violation
from workbook.lesson.prediction import Option, Prediction
from workbook.lesson.sealed_predictions import SUFFIX, seal, unseal

FEWEST_OPTIONS = 3
FEWEST_WORDS = 4
_NAME = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
_OPTION = re.compile(r"- \*\*(?P<letter>[a-z])\*\* (?P<text>\S.*)")
_WHEN = re.compile(r"when `(?P<condition>[^`]+)`")
_CALL = re.compile(
    r"^[ \t]*(?P<what>predict|reveal)\(\s*['\"](?P<name>[^'\"]*)['\"](?P<rest>\s*\))?", re.MULTILINE
)
_ALLOWED = (
    ast.Expression, ast.Compare, ast.BoolOp, ast.BinOp, ast.UnaryOp, ast.Name, ast.Constant, ast.Tuple,
    ast.boolop, ast.operator, ast.unaryop, ast.cmpop, ast.expr_context,
)  # fmt: skip


def read_prediction(name: str, source: str) -> tuple[str, Prediction]:
    """Return a prediction cell's text as the notebook shows it, and the whole prediction.

    Raises ValueError if the cell isn't a valid prediction.
    """
    if not _NAME.fullmatch(name):
        raise ValueError(f"a prediction is named in small letters, digits and -, not {name!r}")
    shown: list[str] = []
    parts: list[_Part] = []
    is_inside = False
    for line in source.split("\n"):
        begins = _OPTION.fullmatch(line)
        if begins:
            parts.append(_Part(begins["letter"], begins["text"]))
        is_inside = bool(begins) or (is_inside and line.startswith("  "))
        if not is_inside or begins or parts[-1].shows(line.strip()):
            shown.append(line)
    return "\n".join(shown), _prediction(name, parts)


class _Part:
    """An option of a prediction while it's being read line by line."""

    def __init__(self, letter: str, text: str) -> None:
        self.letter = letter
        self.text = [text]
        self.why: list[str] = []
        self.sign = ""
        self.when = ""

    def shows(self, line: str) -> bool:
        """Add the option's next line. Return whether the notebook shows that line."""
        condition = _WHEN.fullmatch(line)
        if condition:
            self.when = condition["condition"]
        elif line[:1] in ("✓", "✗"):
            self.sign = line[0]
            self.why.append(line[1:].strip())
        elif self.sign:
            self.why.append(line)
        else:
            self.text.append(line)
            return True
        return False


def _prediction(name: str, parts: Sequence[_Part]) -> Prediction:
    found = "".join(part.letter for part in parts)
    if len(parts) < FEWEST_OPTIONS or found != "abcdefgh"[: len(parts)]:
        raise ValueError(
            f"a prediction needs at least {FEWEST_OPTIONS} options from a on, as lines '- **a** It waits.'"
        )
    for part in parts:
        shown = f"option {part.letter} of {name!r}"
        if not part.sign or len(" ".join(part.why).split()) < FEWEST_WORDS:
            raise ValueError(f"{shown} needs an explanation below it, '  ✗ The period is in seconds.'")
        for mark in marks_in_prediction(" ".join([*part.text, *part.why])):
            raise ValueError(f"{shown}: {mark!r} is shown as it is written, leave out the marks of Markdown")
        if "when `" in " ".join([*part.text, *part.why]):
            raise ValueError(f"{shown}: put the condition on a line by itself, ``  when `late > 0` ``")
        if part.when:
            _check_condition(shown, part.when)
    usual = [part.letter for part in parts if part.sign == "✓"]
    if len(usual) != 1:
        raise ValueError(f"{name!r} needs exactly one option with ✓, but has {len(usual)}")
    conditions = [part.letter for part in parts if part.when]
    if conditions and usual[0] not in conditions:
        raise ValueError(f"the option with ✓ of {name!r} needs a condition, because other options have one")
    options = (Option(one.letter, " ".join(one.text), " ".join(one.why), one.when) for one in parts)
    return Prediction(name, tuple(options), usual[0])


def _check_condition(shown: str, condition: str) -> None:
    try:
        tree = ast.parse(condition, mode="eval")
    except SyntaxError as error:
        raise ValueError(f"{shown}: `{condition}` is not a condition: {error.msg}") from error
    if not all(isinstance(node, _ALLOWED) for node in ast.walk(tree)):
        raise ValueError(f"{shown}: `{condition}` may only compare names and numbers")


def prediction_violations(wanted: Document) -> Iterator[tuple[int, str]]:
    """Yield a line number and a message for each error in a lesson's calls of `predict` and `reveal`."""
    names = {one.name for one in wanted.predictions}
    asked: set[str] = set()
    revealed: set[str] = set()
    for cell in wanted.cells:
        for what, name, closes in _calls(cell):
            if name not in names:
                yield cell.line, f"cell {cell.id}: no cell of this lesson has prediction={name!r}"
            elif what == "predict":
                asked.add(name)
                if not closes:
                    yield cell.line, f"cell {cell.id}: the student chooses, write predict({name!r}) only"
            else:
                revealed.add(name)
                if name not in asked:
                    yield cell.line, f"cell {cell.id} reveals {name!r} before the student is asked"
    for name in sorted(names - asked):
        yield 0, f"the prediction {name!r} is never asked: predict({name!r})"
    for name in sorted(names - revealed):
        yield 0, f"the prediction {name!r} is never revealed: reveal({name!r}, ...)"


def _calls(cell: Cell) -> Iterator[tuple[str, str, bool]]:
    """Yield "predict" or "reveal" for each call, the prediction's name, and whether that name is the only argument.

    Skip calls of `predict` in the old form, with `about=`.
    """
    if cell.kind != "code":
        return
    for found in _CALL.finditer(cell.source):
        if found["what"] == "reveal" or "about=" not in cell.source[found.start() :].split("\n", 1)[0]:
            yield found["what"], found["name"], bool(found["rest"])


def write_sealed(tree: Tree, stem: str, predictions: Sequence[Prediction]) -> None:
    """Write a lesson's sealed predictions to their file. If the lesson has none, remove the file."""
    path = tree.sealed / f"{stem}{SUFFIX}"
    if predictions:
        write(path, seal(predictions))
    else:
        path.unlink(missing_ok=True)


def sealed_violations(tree: Tree, stem: str, wanted: Document) -> Iterator[Violation]:
    """Check that the sealed predictions match the lesson's text."""
    path = tree.sealed / f"{stem}{SUFFIX}"
    try:
        kept = unseal(path.read_text(encoding="utf-8")) if path.is_file() else ()
    except ValueError:
        kept = ()
    if kept != wanted.predictions:
        yield Violation(
            tree.name(path),
            "does not match the predictions in the text of the lesson: run `make notebooks`",
        )


def foreign_sealed(tree: Tree) -> Iterator[Violation]:
    """Yield a violation for each sealed file without a lesson, and for each prediction name that two lessons use."""
    lessons = tree.lesson_stems()
    taken: dict[str, str] = {}
    for path in entries(tree.sealed):
        if path.suffix != SUFFIX or path.stem not in lessons:
            yield Violation(tree.name(path), "belongs to no lesson: remove it")
            continue
        try:
            predictions = unseal(path.read_text(encoding="utf-8"))
        except ValueError:
            continue  # reported along with the lesson
        for name in (one.name for one in predictions):
            if name in taken:
                yield Violation(tree.name(path), f"the prediction {name!r} is also one of {taken[name]}")
            taken.setdefault(name, path.stem)
