"""Generate the table in docs/vocabulary.md: each name in `workbook.criteria`, its arguments, and its description."""

import ast
import importlib
import inspect
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import workbook.criteria
from workbook.criteria import Criterion


def vocabulary(module: ModuleType = workbook.criteria) -> str:
    """Return a table of all names that a criteria file can use, in alphabetical order, functions first."""
    rows = [
        f"| `{spelled(module, name)}` | {first_line(module, name)} |"
        for name in sorted(module.__all__, key=_key)
    ]
    return "\n".join(["| word | what it is |", "|---|---|", *rows])


def _key(name: str) -> tuple[bool, str]:
    """Return a sort key that puts functions before classes and constants."""
    return name[0].isupper(), name


def spelled(module: ModuleType, name: str) -> str:
    """Return a name as the table shows it. A function's arguments follow its name, optional ones in brackets."""
    value = getattr(module, name)
    if not inspect.isfunction(value):
        return name
    given = ""
    for argument in inspect.signature(value).parameters.values():
        word = f"*{argument.name}" if argument.kind is argument.VAR_POSITIONAL else argument.name
        if argument.kind is argument.KEYWORD_ONLY:
            word += "="
        separator = ", " if given else ""
        optional = argument.default is not argument.empty
        given += f"[{separator}{word}]" if optional else f"{separator}{word}"
    return f"{name}({given})"


def first_line(module: ModuleType, name: str) -> str:
    """Return the first paragraph of a name's documentation on one line, for a table cell."""
    value = getattr(module, name)
    if isinstance(value, Criterion):
        value = value.judge
    text = inspect.getdoc(value) if callable(value) else _said_of_constant(module, name)
    paragraph = (text or "").split("\n\n")[0]
    return " ".join(paragraph.split()).replace("|", "\\|")


def _said_of_constant(module: ModuleType, name: str) -> str:
    """Return a constant's docstring from the module that defines it, or "" if there is none."""
    for node in ast.walk(ast.parse(Path(str(module.__file__)).read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.module and name in [alias.name for alias in node.names]:
            origin = importlib.import_module(node.module)
            return dict(_texts_of_constants(Path(str(origin.__file__)))).get(name, "")
    return ""


def _texts_of_constants(path: Path) -> Iterator[tuple[str, str]]:
    body = ast.parse(path.read_text(encoding="utf-8")).body
    for node, after in zip(body, body[1:], strict=False):
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
            if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant):
                yield node.targets[0].id, str(after.value.value)
