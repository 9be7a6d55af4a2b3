"""Every notebook runs from top to bottom and shows its committed outputs, checked with strict nbval.

In the whole run, JupyterLab runs the lessons instead if there is a Chromium, and `test_browser_lessons` compares them.
"""

import time
from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.calm import MOST_TAKEN, TRIES, await_calm, taken_s
from workbook.authoring.comparing import compare_stems
from workbook.authoring.tree import Tree

ROOT = Path(__file__).resolve().parents[2]
TREE = Tree(ROOT)
LESSONS, EXERCISES = TREE.lesson_stems(), TREE.exercise_stems()
LONG = frozenset({"10_slow_callbacks", "15_camera", "16_ai_model"})
"""Lessons that take more than a minute even if nothing else runs. Only the whole run includes them."""


def test_there_is_something_to_run() -> None:
    assert LESSONS
    assert EXERCISES


@pytest.mark.slow
@pytest.mark.outside_browser
@pytest.mark.parametrize(
    "stem", [pytest.param(stem, marks=pytest.mark.whole if stem in LONG else ()) for stem in LESSONS]
)
def test_a_lesson_shows_what_is_committed(stem: str, capfd: pytest.CaptureFixture[str]) -> None:
    show_what_is_committed(capfd, lessons=[stem])


@pytest.mark.slow
@pytest.mark.parametrize("stem", EXERCISES)
def test_an_exercise_shows_what_is_committed(stem: str, capfd: pytest.CaptureFixture[str]) -> None:
    """Run it with the starter, and with the solution inserted."""
    show_what_is_committed(capfd, exercises=[stem])


def show_what_is_committed(
    capfd: pytest.CaptureFixture[str], *, lessons: Sequence[str] = (), exercises: Sequence[str] = ()
) -> None:
    """Fail unless these notebooks show their committed outputs.

    A failure proves nothing while the host gave the CPUs to others, so those notebooks run again.
    """
    for _ in range(TRIES):
        began, before = time.monotonic(), taken_s()
        failed = compare_stems(TREE, lessons, exercises)
        output = capfd.readouterr().out
        if not failed or taken_s() - before < MOST_TAKEN * (time.monotonic() - began):
            break
        await_calm()
    assert not failed, output
