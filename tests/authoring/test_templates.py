"""The output of `workbook new` passes every check unchanged: the rules, ruff, mypy, nbval, and the proofs."""

import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from workbook.authoring.building import build
from workbook.authoring.checking import check
from workbook.authoring.comparing import compare
from workbook.authoring.skeleton import TEMPLATES, new_exercise, new_lesson, still_from_template
from workbook.authoring.tree import Tree
from workbook.cli import new
from workbook.cli.main import main

ROOT = Path(__file__).resolve().parents[2]
SLUGS = {
    "publisher": "knee",
    "listener": "distance_of_whatever_is_near",
    "service": "left_hand",
    "function": "nearest_obstacle",
}
"""Short and long names, because names determine the length of lines."""

pytestmark = [pytest.mark.slow, pytest.mark.whole]


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Tree]:
    """Build a course of four exercises, one per template, and their lessons. Don't change it."""
    tree = Tree(tmp_path_factory.mktemp("templates"))
    tree.criteria.mkdir(parents=True)
    for name in ("README.md", "CONTRIBUTING.md", "pyproject.toml"):
        shutil.copy(ROOT / name, tree.root)
    # A copy, not a link, because the build writes the predictions' sealed answers there.
    unwanted = shutil.ignore_patterns("__pycache__", "sealed")
    shutil.copytree(ROOT / "workbook", tree.root / "workbook", ignore=unwanted)
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("WORKBOOK_COURSE", str(tree.root))
        first, *others = TEMPLATES
        assert main(["new", "exercise", f"00_{SLUGS[first]}", "--template", first]) == 0
        for template in others:
            new_exercise(tree, SLUGS[template], template)
        for number in range(1, len(TEMPLATES)):
            new_lesson(tree, f"{number:02d}_lesson_{number}")
        said: list[str] = []
        assert build(tree, jobs=len(TEMPLATES), say=said.append) == 0, said
        assert main(["new", "lesson", "00_lesson_0"]) == 0
        yield tree


def run(course: Tree, *command: str, **environ: str) -> None:
    done = subprocess.run(
        [sys.executable, "-m", *command],
        cwd=course.root,
        env=os.environ | environ,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert done.returncode == 0, f"{' '.join(command)}\n{done.stdout}{done.stderr}"


def test_every_rule_is_kept(course: Tree) -> None:
    assert list(map(str, check(course))) == []
    assert len(course.exercise_stems()) == len(course.lesson_stems()) == len(TEMPLATES)


def test_the_command_offers_the_templates_that_there_are() -> None:
    assert new.TEMPLATES == TEMPLATES == tuple(SLUGS)


def test_what_is_still_to_be_written_is_noted_and_no_failure(
    course: Tree, capsys: pytest.CaptureFixture[str]
) -> None:
    run(course, "workbook.authoring", "check")
    noted = {one.where for one in still_from_template(course)}
    for stem in course.exercise_stems():
        assert f"solutions/{stem}.py" in noted
        assert f"exercises/criteria/{stem}.py" in noted
    assert "notebooks/sources/00_lesson_0.py" in noted


def test_style_and_types_are_right(course: Tree) -> None:
    run(course, "ruff", "check", ".")
    run(course, "ruff", "format", "--check", ".")
    run(course, "mypy", "exercises/criteria")
    run(course, "mypy", "solutions")


def test_the_notebooks_show_what_they_should(course: Tree, capfd: pytest.CaptureFixture[str]) -> None:
    """Check one lesson, and every exercise with the starter and then with the solution inserted."""
    failed = compare(course, ["00_lesson_0", *course.exercise_stems()], jobs=len(TEMPLATES))
    assert not failed, capfd.readouterr().out


def test_the_exercises_prove_themselves(course: Tree) -> None:
    proofs = str(ROOT / "tests" / "exercises" / "test_proofs.py")
    run(
        course,
        "pytest",
        "-q",
        f"--rootdir={ROOT}",
        proofs,
        PYTHONPATH=str(ROOT),
    )
