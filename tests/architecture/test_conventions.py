"""The conventions for all modules of `workbook/`: docstrings, sizes, and one name per concept."""

import ast
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
WORKBOOK = ROOT / "workbook"
MODULES = sorted(path for path in WORKBOOK.rglob("*.py") if "typings" not in path.parts)
PACKAGES = sorted(path for path in MODULES if path.name == "__init__.py" and path.parent != WORKBOOK)

Definition = ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef


def name_of(path: Path) -> str:
    return str(path.relative_to(WORKBOOK))


def tree_of(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"))


def public(body: list[ast.stmt]) -> Iterator[Definition]:
    """Return the public functions and classes of a module, and the public methods of those classes."""
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)) and node.name[0] != "_":
            yield node
            if isinstance(node, ast.ClassDef):
                yield from public(node.body)


def begins_with_a_sentence(node: Definition | ast.Module) -> bool:
    text = ast.get_docstring(node) or ""
    return text.split("\n")[0].rstrip().endswith(".")


@pytest.mark.parametrize("path", PACKAGES, ids=name_of)
def test_a_package_says_what_lives_there_and_what_may_be_imported(path: Path) -> None:
    text = ast.get_docstring(tree_of(path)) or ""
    sentences = re.findall(r"[.!?](?=\s|$)", text)
    assert len(sentences) >= 2, f"{name_of(path)} needs two sentences, and says {text!r}"


def test_public_names_have_a_docstring_that_begins_with_a_sentence() -> None:
    lacking = [
        f"{name_of(path)}:{node.lineno} {node.name}"
        for path in MODULES
        for node in public(tree_of(path).body)
        if not begins_with_a_sentence(node)
    ]
    assert not lacking, "\n".join(lacking)


def test_no_two_classes_share_a_name() -> None:
    names = Counter(
        node.name
        for path in MODULES
        for node in tree_of(path).body
        if isinstance(node, ast.ClassDef) and node.name[0] != "_"
    )
    assert [name for name, count in names.items() if count > 1] == []
