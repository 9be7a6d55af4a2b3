"""Every notebook runs from top to bottom and shows what is committed: strict nbval, lesson by lesson."""

from pathlib import Path

import pytest

from workbook.authoring.comparing import compare
from workbook.authoring.tree import Tree

ROOT = Path(__file__).resolve().parents[2]
TREE = Tree(ROOT)
STEMS = sorted({*TREE.lesson_stems(), *TREE.exercise_stems()})
NUMBERS = sorted({stem[:2] for stem in STEMS})


def test_there_is_something_to_run() -> None:
    assert NUMBERS


@pytest.mark.slow
@pytest.mark.parametrize("number", NUMBERS)
def test_a_lesson_and_its_exercise_show_what_is_committed(
    number: str, capfd: pytest.CaptureFixture[str]
) -> None:
    """The lesson as it is, the exercise with the starter, and the exercise with the solution put in."""
    failed = compare(TREE, [number])
    assert not failed, capfd.readouterr().out
