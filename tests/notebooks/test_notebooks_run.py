"""Every notebook runs from top to bottom and shows what is committed: strict nbval, lesson by lesson."""

from dataclasses import dataclass
from pathlib import Path

import pytest

from workbook.authoring.comparing import compare
from workbook.authoring.tree import Tree

ROOT = Path(__file__).resolve().parents[2]
TREE = Tree(ROOT)
STEMS = sorted({*TREE.lesson_stems(), *TREE.exercise_stems()})
NUMBERS = sorted({stem[:2] for stem in STEMS})
TRIES = 3
MOST_TAKEN = 0.05
"""Of the processors' time, by other machines on the same host: with more than that, a lesson cannot keep time."""


@dataclass(frozen=True)
class Processors:
    """What the processors did since the machine was started, in ticks."""

    stolen: int
    everything: int

    def taken_since(self, before: "Processors") -> float:
        """The share of the time since then that the host gave to other machines."""
        return (self.stolen - before.stolen) / max(1, self.everything - before.everything)


def processors() -> Processors:
    """From the first line of /proc/stat; see proc(5)."""
    ticks = [int(word) for word in Path("/proc/stat").read_text().split("\n", 1)[0].split()[1:9]]
    return Processors(ticks[7], sum(ticks))


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
        before = processors()
        failed = compare(TREE, [number])
        output = capfd.readouterr().out
        if not failed or processors().taken_since(before) < MOST_TAKEN:
            break
    assert not failed, output
