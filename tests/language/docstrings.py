"""Find the functions whose docstring doesn't begin with a verb."""

import ast
from collections.abc import Iterator, Sequence
from pathlib import Path

from tests.language.texts import name, paths

FUNCTIONS = ("workbook/**/*.py",)
NOT_VERBS = frozenset(
    "A After All An Another As At Both By Each Every Everything For From Half How If In It Its No None Of On One Only "
    "Some Such That The There These This Those To Two Until What When Where Whether Which Who Whose Why With Without "
    "Zero".split()
)
"""Words that begin a description instead of saying what the function does."""
ATTRIBUTES = ("property", "cached_property")


def is_verb(word: str) -> bool:
    """Return whether a first word may be an imperative: it isn't in NOT_VERBS, and doesn't end in a single s."""
    bare = word.rstrip(".,:;")
    return bare[:1].isupper() and bare not in NOT_VERBS and (not bare.endswith("s") or bare.endswith("ss"))


def without_verbs(path: Path) -> Iterator[str]:
    """Yield the place and first line of each such docstring. Properties are skipped, because they describe a value."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and not _is_attribute(node):
            said = ast.get_docstring(node)
            if said and not is_verb(said.split()[0]):
                yield f"{name(path)}:{node.lineno}: {said.splitlines()[0]}"


def _is_attribute(node: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    return any(ast.unparse(one).rpartition(".")[2] in ATTRIBUTES for one in node.decorator_list)


def all_without_verbs(patterns: Sequence[str] = FUNCTIONS) -> list[str]:
    """Return the complaints about all modules."""
    return [found for path in paths(patterns) for found in without_verbs(path)]
