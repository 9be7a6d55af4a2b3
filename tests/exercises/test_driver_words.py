"""A driver and its exercise's criteria share topics, words, and times.

They can't share a module, because the driver must work without the workbook.
"""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from workbook.exercise.definition import load_exercise

ROOT = Path(__file__).resolve().parents[2]
DRIVERS = sorted((ROOT / "exercises" / "drivers").glob("*.py"))
TOPIC = re.compile(r"/driver/\w+")

# The parts of a driver's reports by which the criteria distinguish them.
WORDS = {
    "03_publishers_and_messages": ("done", "made", "not made: ", "call ", "returned", "raised"),
    "06_spinning": ("missing", "end", "raised"),
    "07_typed_nodes": ("returned", "\t"),
}


def tree_of(path: Path) -> ast.Module:
    """Parse the program, and remove its docstrings."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and ast.get_docstring(node):
            node.body = node.body[1:]
    return tree


def strings(tree: ast.Module) -> list[str]:
    return [
        node.value
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
    ]


def constants(tree: ast.Module) -> Iterator[tuple[str, object]]:
    """Return the name and value of each number that a file defines."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Constant):
            for target in node.targets:
                if isinstance(target, ast.Name):
                    yield target.id, node.value.value


@pytest.fixture(params=DRIVERS, ids=lambda path: path.stem)
def driver(request: pytest.FixtureRequest) -> Path:
    assert isinstance(request.param, Path)
    return request.param


@pytest.fixture
def criteria(driver: Path) -> ast.Module:
    return tree_of(ROOT / "exercises" / "criteria" / driver.name)


def test_both_name_the_same_topics_of_the_driver(driver: Path, criteria: ast.Module) -> None:
    theirs, ours = (
        {text for text in strings(tree) if TOPIC.fullmatch(text)} for tree in (tree_of(driver), criteria)
    )
    assert theirs == ours != set()


def test_all_topics_of_the_driver_are_signed(driver: Path) -> None:
    exercise = load_exercise(driver.stem, ROOT)
    declared = {name for name in exercise.plan.topics if name.startswith("/driver/")}
    assert declared and declared <= {*exercise.signed}


def test_what_criteria_look_for_is_what_the_driver_reports(driver: Path, criteria: ast.Module) -> None:
    assert WORDS.keys() == {path.stem for path in DRIVERS}
    for word in WORDS[driver.stem]:
        for tree in (tree_of(driver), criteria):
            assert any(word in text for text in strings(tree)), word


def test_a_number_with_one_name_has_one_value(driver: Path, criteria: ast.Module) -> None:
    theirs, ours = dict(constants(tree_of(driver))), dict(constants(criteria))
    shared = theirs.keys() & ours.keys()
    assert {name: theirs[name] for name in shared} == {name: ours[name] for name in shared}
