"""What in a program keeps mypy from looking at it: comments that silence it, and code that it is told to skip."""

import ast
import io
import re
import tokenize
from collections.abc import Iterator

from workbook.recording.recording import SILENCED, UNCHECKED, Finding

_IGNORE = re.compile(
    r"#\s*type:\s*ignore\b"
)  # at the beginning of a comment; elsewhere mypy does not heed it
_INLINE = re.compile(r"^# mypy: .*$", re.MULTILINE)
_HIDING = ("TYPE_CHECKING", "MYPY")


def _comments(program: str) -> Iterator[tokenize.TokenInfo]:
    try:
        for token in tokenize.generate_tokens(io.StringIO(program).readline):
            if token.type == tokenize.COMMENT:
                yield token
    except (tokenize.TokenError, SyntaxError):
        return  # mypy will say that it cannot read the file


def without_silencers(program: str) -> str:
    """The program with every comment taken out that would silence mypy. Lines keep their numbers."""
    lines = program.splitlines(keepends=True)
    for token in _comments(program):
        if _IGNORE.match(token.string):
            row, column = token.start
            end = "\n" if lines[row - 1].endswith("\n") else ""
            lines[row - 1] = lines[row - 1][:column].rstrip() + end
    return _INLINE.sub("#", "".join(lines))


def evasions(program: str) -> Iterator[Finding]:
    """Everything in a program that keeps mypy from looking, as findings of the codes "silenced" and "unchecked"."""
    for token in _comments(program):
        if _IGNORE.match(token.string):
            yield Finding("", token.start[0], SILENCED, token.string.strip())
    line, counted = 1, 0
    for found in _INLINE.finditer(program):
        line += program.count("\n", counted, found.start())
        counted = found.start()
        yield Finding("", line, SILENCED, found[0].strip())
    try:
        tree = ast.parse(program)
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return  # mypy will say that it cannot read the file
    for node in ast.walk(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            for decorator in node.decorator_list:
                if _last_name(decorator) == "no_type_check":
                    yield Finding("", decorator.lineno, UNCHECKED, "@no_type_check")
        elif isinstance(node, ast.If) and (hidden := _hidden_code(node)) is not None:
            yield Finding("", hidden.lineno, UNCHECKED, "code that runs, and that mypy is told to skip")


def _last_name(node: ast.expr) -> str:
    if isinstance(node, ast.Attribute):
        return node.attr
    return node.id if isinstance(node, ast.Name) else ""


def _hidden_code(node: ast.If) -> ast.stmt | None:
    """The first statement of the branch that runs, but is not for the eyes of a type checker. Imports may be there."""
    names = {_last_name(part) for part in ast.walk(node.test) if isinstance(part, ast.expr)}
    if names.isdisjoint(_HIDING):
        return None
    turned = isinstance(node.test, ast.UnaryOp) and isinstance(node.test.op, ast.Not)
    runs = node.body if turned else node.orelse
    return next((one for one in runs if not isinstance(one, (ast.Import, ast.ImportFrom, ast.Pass))), None)
