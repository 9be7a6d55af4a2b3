"""Lessons show numbers instead of True and False, and let readers write lines that run."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat
import pytest

from workbook.authoring.plain_helpers import TITLE

FOLDER = Path(__file__).resolve().parents[2] / "notebooks"
NOTEBOOKS = sorted(path.stem for path in FOLDER.glob("[0-9][0-9]_*.ipynb"))
LESSONS = [stem for stem in NOTEBOOKS if not stem.endswith("_deeper")]
MOST_VERDICTS = 1
FEWEST_BLANKS = {True: 3, False: 1}
"""In a lesson, and in a deeper page."""
_VERDICT = re.compile(r"(?<!gave )\b(True|False)\b")  # the value that a cell returned is no verdict
_CHECKED = re.compile(r"\byours\(")


def cells(stem: str, kind: str) -> Iterator[Any]:
    notebook = nbformat.read(FOLDER / f"{stem}.ipynb", nbformat.NO_CONVERT)
    return (cell for cell in notebook.cells if cell.cell_type == kind)


@pytest.mark.parametrize("stem", NOTEBOOKS)
def test_a_lesson_prints_numbers(stem: str) -> None:
    printed = [
        line
        for cell in cells(stem, "code")
        for output in cell.outputs
        if output.output_type == "stream"
        for line in output.text.splitlines()
    ]
    assert len([line for line in printed if _VERDICT.search(line)]) <= MOST_VERDICTS


@pytest.mark.parametrize("stem", NOTEBOOKS)
def test_a_reader_writes_lines_that_are_checked(stem: str) -> None:
    checked = [cell.source for cell in cells(stem, "code") if _CHECKED.search(cell.source)]
    assert len(checked) >= FEWEST_BLANKS[stem in LESSONS]
    assert all("..." in source and "# TODO" in source for source in checked)


@pytest.mark.parametrize("stem", LESSONS)
def test_folds_show_plain_rclpy_for_the_helpers(stem: str) -> None:
    """Only `init` is checked, because a lesson that creates a node needs it.

    The folds for the other helpers come with it.
    """
    folds = [cell.source for cell in cells(stem, "markdown") if TITLE in cell.source]
    assert folds
    if any(re.search(r"(?<![\w.])init\(\)", cell.source) for cell in cells(stem, "code")):
        assert "rclpy.init()" in "".join(folds)
