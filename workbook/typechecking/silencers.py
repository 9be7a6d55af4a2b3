"""Find what keeps mypy from checking a program: comments that silence mypy, and code that makes it skip code."""

import ast
import io
import re
import tokenize
from collections.abc import Iterator

from workbook.recording.recording import SILENCED, UNCHECKED, Finding

_IGNORE = re.compile(
    r"#\s*type:\s*ignore\b"
)  # mypy honors it only at the beginning of a comment and ignores it elsewhere
_INLINE = re.compile(r"^# mypy: .*$", re.MULTILINE)
_HIDING = ("TYPE_CHECKING", "MYPY", "PY2", "PY3")
"""Names that mypy always assumes to be true or to be false (`infer_condition_value` in mypy/reachability.py)."""
_ABOUT_THE_MACHINE = ("platform", "version_info")
"""The attributes of `sys` that mypy assumes to be constant, even if the program changes them."""
_WHAT_HIDES = "code that runs although mypy is told to skip it"
_FOR_CHECKERS = (
    *(ast.Import, ast.ImportFrom, ast.Pass, ast.Assign, ast.AnnAssign),
    *(ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef),
    getattr(ast, "TypeAlias", ast.Pass),  # since Python 3.12
)
"""The statements that are allowed in code for type checkers only.

Others, such as `return`, would make mypy skip the code after them.
"""


def _comments(program: str) -> Iterator[tokenize.TokenInfo]:
    try:
        for token in tokenize.generate_tokens(io.StringIO(program).readline):
            if token.type == tokenize.COMMENT:
                yield token
    except (tokenize.TokenError, SyntaxError):
        return  # mypy will report that it cannot read the file


def without_silencers(program: str) -> str:
    """Remove all comments that would silence mypy. The line numbers don't change."""
    lines = program.splitlines(keepends=True)
    for token in _comments(program):
        if _IGNORE.match(token.string):
            row, column = token.start
            end = "\n" if lines[row - 1].endswith("\n") else ""
            lines[row - 1] = lines[row - 1][:column].rstrip() + end
    return _INLINE.sub("#", "".join(lines))


def evasions(program: str) -> Iterator[Finding]:
    """Yield a finding for each place that keeps mypy from checking the program.

    A finding's code is "silenced" for a comment that silences mypy, and "unchecked" for code that mypy skips.
    """
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
        return  # mypy will report that it cannot read the file
    explained: set[ast.AST] = set()
    systems = _names_of_sys(tree)
    for node in ast.walk(tree):  # visits an `if` before its parts
        if _is_another_sys(node) or _misjudged(node):
            yield Finding("", getattr(node, "lineno", 1), UNCHECKED, _WHAT_HIDES)
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            for decorator in node.decorator_list:
                if _last_name(decorator) == "no_type_check":
                    yield Finding("", decorator.lineno, UNCHECKED, "@no_type_check")
        elif isinstance(node, ast.If) and _asks_for_checkers(node.test):
            explained |= {*ast.walk(node.test)}
            hidden = _hidden_code(node)
            if hidden is not None:
                yield Finding("", hidden.lineno, UNCHECKED, _WHAT_HIDES)
        elif isinstance(node, (ast.Name, ast.Attribute)) and node not in explained and _hides(node, systems):
            yield Finding("", node.lineno, UNCHECKED, _WHAT_HIDES)


def _last_name(node: ast.expr) -> str:
    if isinstance(node, ast.Attribute):
        return node.attr
    return node.id if isinstance(node, ast.Name) else ""


def _names_of_sys(tree: ast.Module) -> frozenset[str]:
    """Return the program's names for the module `sys`."""
    aliases = (one for node in ast.walk(tree) if isinstance(node, ast.Import) for one in node.names)
    return frozenset(one.asname or one.name for one in aliases if one.name == "sys")


def _hides(node: ast.Name | ast.Attribute, systems: frozenset[str]) -> bool:
    """Return whether a node outside of an `if TYPE_CHECKING:` test makes mypy skip code.

    Such a node reads a name in `_HIDING` or changes an attribute of `sys` that mypy assumes to be constant.
    """
    if isinstance(node.ctx, ast.Load):
        return _last_name(node) in _HIDING
    return (
        isinstance(node, ast.Attribute)
        and node.attr in _ABOUT_THE_MACHINE
        and isinstance(node.value, ast.Name)
        and node.value.id in systems
    )


def _asks_for_checkers(test: ast.expr) -> bool:
    """Return whether the test consists only of a name such as `TYPE_CHECKING`, or of `not` and such a name."""
    if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not):
        test = test.operand
    return _last_name(test) in _HIDING


def _hidden_code(node: ast.If) -> ast.stmt | None:
    """Return the first statement of an `if TYPE_CHECKING:` that hides code from mypy, or None if there is none.

    The branch that runs may contain only imports and `pass`, because mypy skips it. In the branch that doesn't run, no
    statement may make mypy skip the code after it.
    """
    turned = isinstance(node.test, ast.UnaryOp) or _last_name(node.test) == "PY2"
    runs, skipped = (node.body, node.orelse) if turned else (node.orelse, node.body)
    for one in runs:
        if not isinstance(one, (ast.Import, ast.ImportFrom, ast.Pass)):
            return one
    return next((one for one in skipped if not isinstance(one, _FOR_CHECKERS) and not _is_text(one)), None)


def _is_text(node: ast.stmt) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)


def _is_another_sys(node: ast.AST) -> bool:
    """Return whether this node defines another object named `sys`, which mypy would mistake for the module."""
    if isinstance(node, ast.arg):
        return node.arg == "sys"
    if isinstance(node, ast.alias):
        return node.asname == "sys" and node.name != "sys"
    if isinstance(node, (ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)):
        return node.name == "sys"
    return isinstance(node, ast.Name) and node.id == "sys" and not isinstance(node.ctx, ast.Load)


def _misjudged(node: ast.AST) -> bool:
    """Return whether a comparison with `sys.version_info` may have a different result in mypy than in Python.

    mypy compares only the first two of the five numbers. Only `sys.version_info >=` and `sys.version_info <` are safe.
    """
    if not isinstance(node, ast.Compare):
        return False
    sides = [node.left, *node.comparators]
    whole = [isinstance(one, ast.Attribute) and one.attr == "version_info" for one in sides]
    return any(whole) and not (whole[0] and len(node.ops) == 1 and isinstance(node.ops[0], (ast.GtE, ast.Lt)))
