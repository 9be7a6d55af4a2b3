"""Every notebook runs from top to bottom and shows what is committed: strict nbval, lesson by lesson.

Where there is a Chromium, the lessons are run in JupyterLab, and compared there (`test_browser_lessons`).
"""

import time
from pathlib import Path

import pytest

from tests.calm import MOST_TAKEN, TRIES, await_calm, taken_s
from workbook.authoring.comparing import compare
from workbook.authoring.tree import Tree
from workbook.lab.health import chromium

ROOT = Path(__file__).resolve().parents[2]
TREE = Tree(ROOT)
LESSONS_TOO = chromium() is None
STEMS = sorted({*(TREE.lesson_stems() if LESSONS_TOO else ()), *TREE.exercise_stems()})
NUMBERS = sorted({stem[:2] for stem in STEMS})


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
        failed = compare(TREE, [number], lessons=LESSONS_TOO)
        output = capfd.readouterr().out
        if not failed or taken_s() - before < MOST_TAKEN * (time.monotonic() - began):
            break
        await_calm()
    assert not failed, output
