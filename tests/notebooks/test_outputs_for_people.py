"""Lessons that were rewritten show numbers, not True and False, and let the reader write lines that run."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import nbformat
import pytest

FOLDER = Path(__file__).resolve().parents[2] / "notebooks"
REWRITTEN = (
    "09_joint_positions",
    "11_polling_against_callbacks",
    "12_services",
    "13_qos_and_discovery",
    "15_camera",
)
"""Lessons in the form of lesson 15. Others follow one by one."""
MOST_VERDICTS, FEWEST_BLANKS = 1, 3
_VERDICT = re.compile(r"\b(True|False)\b")
_CHECKED = re.compile(r"\byours\(")


def cells(stem: str, kind: str) -> Iterator[Any]:
    notebook = nbformat.read(FOLDER / f"{stem}.ipynb", nbformat.NO_CONVERT)
    return (cell for cell in notebook.cells if cell.cell_type == kind)


@pytest.mark.parametrize("stem", REWRITTEN)
def test_a_lesson_prints_numbers(stem: str) -> None:
    printed = [
        line
        for cell in cells(stem, "code")
        for output in cell.outputs
        if output.output_type == "stream"
        for line in output.text.splitlines()
    ]
    assert len([line for line in printed if _VERDICT.search(line)]) <= MOST_VERDICTS


@pytest.mark.parametrize("stem", REWRITTEN)
def test_a_reader_writes_at_least_three_lines_and_each_is_checked(stem: str) -> None:
    checked = [cell.source for cell in cells(stem, "code") if _CHECKED.search(cell.source)]
    assert len(checked) >= FEWEST_BLANKS
    assert all("..." in source and "# TODO" in source for source in checked)


@pytest.mark.parametrize("stem", REWRITTEN)
def test_a_fold_shows_plain_rclpy(stem: str) -> None:
    folds = [cell.source for cell in cells(stem, "markdown") if "The same without helpers" in cell.source]
    assert len(folds) == 1
    assert "rclpy.init()" in folds[0]
