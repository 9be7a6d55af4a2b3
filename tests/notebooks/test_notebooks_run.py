"""Every notebook runs from top to bottom and shows what is committed: strict nbval, lesson by lesson."""

import time
from pathlib import Path

import pytest

from tests.calm import await_calm, taken_s
from workbook.authoring.comparing import compare
from workbook.authoring.tree import Tree

ROOT = Path(__file__).resolve().parents[2]
TREE = Tree(ROOT)
STEMS = sorted({*TREE.lesson_stems(), *TREE.exercise_stems()})
NUMBERS = sorted({stem[:2] for stem in STEMS})
TRIES = 3
MOST_TAKEN = 0.01
"""Of the processors' time, by other machines on the same host: a standstill of a second is enough to upset a lesson."""


def test_there_is_something_to_run() -> None:
    assert NUMBERS


@pytest.mark.slow
@pytest.mark.parametrize("number", NUMBERS)
def test_a_lesson_and_its_exercise_show_what_is_committed(
    number: str, capfd: pytest.CaptureFixture[str]
) -> None:
    """The lesson as it is, the exercise with the starter, and the exercise with the solution put in.

    What failed while the host gave the processors to others has shown nothing, and is run again.
    """
    for _ in range(TRIES):
        began, before = time.monotonic(), taken_s()
        failed = compare(TREE, [number])
        output = capfd.readouterr().out
        if not failed or taken_s() - before < MOST_TAKEN * (time.monotonic() - began):
            break
        await_calm()
    assert not failed, output
