"""Build a small course: one lesson on plain Python, and one exercise from the skeleton."""

import shutil
from pathlib import Path

import pytest

from workbook.authoring.building import build
from workbook.authoring.skeleton import new_exercise
from workbook.authoring.tree import Tree

LESSON = Path(__file__).with_name("lesson_text.txt").read_text(encoding="utf-8")


def make_course(root: Path) -> Tree:
    tree = Tree(root)
    tree.sources.mkdir(parents=True)
    tree.lesson_nodes.mkdir()
    (tree.lesson_nodes / "beeper.py").write_text("RATE_HZ = 2\n", encoding="utf-8")
    (tree.sources / "21_beeps.py").write_text(LESSON, encoding="utf-8")
    new_exercise(tree, "21_beeps")
    return tree


@pytest.fixture(scope="session")
def built_once(tmp_path_factory: pytest.TempPathFactory) -> Tree:
    """Build and run the course's notebooks once. Don't change the result."""
    tree = make_course(tmp_path_factory.mktemp("built") / "course")
    said: list[str] = []
    assert build(tree, say=said.append) == 0, said
    return tree


@pytest.fixture
def course(built_once: Tree, tmp_path: Path) -> Tree:
    """Copy the built course, so that a test may change it."""
    shutil.copytree(built_once.root, tmp_path / "course")
    return Tree(tmp_path / "course")
