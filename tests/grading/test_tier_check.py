"""The slot that tries a tier isn't wasted: it also judges the first answer."""

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.programs.support import is_gone
from workbook.exercise.answers import Answer
from workbook.grading import tier_check
from workbook.grading.judges import Job
from workbook.grading.slots import pool
from workbook.grading.slots.client import Slot
from workbook.grading.slots.pool import warm_slots
from workbook.grading.slots.scheduler import judge_all
from workbook.isolation import tiers

STEM = "09_joint_positions"
pytestmark = [pytest.mark.slow, pytest.mark.whole]


@pytest.fixture(autouse=True)
def untried() -> Iterator[None]:
    """Clear the results of earlier tier checks, before and after each test."""
    tier_check.tier_problem.cache_clear()
    yield
    tier_check.tier_problem.cache_clear()


@pytest.fixture
def started(monkeypatch: pytest.MonkeyPatch) -> list[Slot]:
    """Collect every slot that is started from now on."""
    found: list[Slot] = []

    class Noted(Slot):
        def __init__(self, *arguments: object, **more: object) -> None:
            super().__init__(*arguments, **more)  # type: ignore[arg-type]
            found.append(self)

    for module in (pool, tier_check):
        monkeypatch.setattr(module, "Slot", Noted)
    return found


def judge_one() -> str:
    [(_, judgement)] = judge_all([Job("one", STEM, Answer("robot = = 1\n"))], 1)
    return judgement.status


def test_the_slot_that_tried_it_judges_the_first_answer_and_ends(started: list[Slot]) -> None:
    assert tier_check.tier_problem("limits") is None
    assert tier_check.tier_problem("limits") is None
    assert judge_one() == "graded"
    [slot] = started
    assert not slot.is_running
    assert judge_one() == "graded"
    assert len(started) == 2, "it is taken once"


def test_a_slot_with_another_environment_is_not_taken(
    started: list[Slot], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    assert tier_check.tier_problem("limits") is None
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    assert judge_one() == "graded"
    first, second = started
    assert second.environ["PYTHONPATH"] == str(tmp_path)
    assert not first.is_running


def test_a_slot_that_has_ended_meanwhile_is_not_taken(started: list[Slot]) -> None:
    assert tier_check.tier_problem("limits") is None
    started[0].kill()
    assert judge_one() == "graded"
    assert len(started) == 2


def test_what_nobody_takes_ends(started: list[Slot]) -> None:
    assert tier_check.tier_problem("limits") is None
    warm_slots.close()
    assert not started[0].is_running
    assert is_gone(started[0]._process.pid)


def test_a_slot_that_breaks_is_a_tier_that_does_not_work(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "/bin/false")
    assert tier_check.tier_problem("limits") == "the self-test broke: the slot ended with code 1"


def test_what_a_program_could_do_there_is_the_problem(
    started: list[Slot], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Programs in this slot should be confined but aren't, because its tier is replaced."""
    (tmp_path / "sitecustomize.py").write_text(
        "import workbook.isolation.tiers as tiers\n"
        "from workbook.isolation.limits import LimitsTier\n"
        "tiers.make_tier = lambda *_, **more: LimitsTier()\n"
    )
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    # The tier is replaced anyway, so this kernel's features don't matter.
    monkeypatch.setattr(tiers, "landlock_abi", lambda: 1)
    problem = tier_check.tier_problem("landlock")
    assert problem is not None
    assert "it does not isolate here" in problem
    assert "reads a file of the judge" in problem
    assert not started[0].is_running
