"""Find the causes in a criteria file or a module of the vocabulary without running it.

A cause's id is the key of its text in the catalog, or a literal in the call that makes the feedback. The call is
`failed("rate.too-fast", saw, expected, because, try)`, or a local function or table row that also takes the id.
"""

import ast
from collections.abc import Iterator
from pathlib import Path

from workbook.criteria.rules import Words
from workbook.criteria.verdict import CAUSE

ROOT = Path(__file__).resolve().parents[2]
VERDICTS = ("failed", "partial")


def vocabulary() -> list[Path]:
    """Return the modules of the vocabulary."""
    folder = ROOT / "workbook" / "criteria" / "vocabulary"
    return [path for path in sorted(folder.glob("*.py")) if path.name != "__init__.py"]


def exercises() -> list[Path]:
    """Return the criteria files of the exercises."""
    return sorted((ROOT / "exercises" / "criteria").glob("*.py"))


class Source:
    """A parsed source file."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._tree = ast.parse(path.read_text(encoding="utf-8"))

    def causes(self) -> list[str]:
        """Return all causes that are named, each as many times as it occurs. Those of the catalog occur once."""
        catalog = self._path.with_suffix(".toml")
        in_catalog = Words(str(self._path)).causes() if catalog.is_file() else set()
        literals = [
            str(value.value)
            for call in self._calls()
            for value in _first_or_cause(call)
            if isinstance(value, ast.Constant) and is_cause(value.value)
        ]
        return [*in_catalog, *(cause for cause in literals if cause not in in_catalog)]

    def verdicts(self) -> Iterator[tuple[int, ast.expr | None]]:
        """Return the line and first argument of each call of `failed` and `partial`."""
        for call in self._calls():
            if _called(call) in VERDICTS:
                yield call.lineno, next(iter(_first_or_cause(call)), None)

    def _calls(self) -> Iterator[ast.Call]:
        return (node for node in ast.walk(self._tree) if isinstance(node, ast.Call))


def is_cause(value: object) -> bool:
    """Return whether a value is a cause's id."""
    return isinstance(value, str) and CAUSE.fullmatch(value) is not None


def _first_or_cause(call: ast.Call) -> list[ast.expr]:
    """Return a call's arguments that may be a cause: the first one, and the one with that name."""
    return [*call.args[:1], *(one.value for one in call.keywords if one.arg == "cause")]


def _called(call: ast.Call) -> str:
    if isinstance(call.func, ast.Attribute):
        return call.func.attr
    return call.func.id if isinstance(call.func, ast.Name) else ""
