"""What commands print fits into 80 columns, and into 60 where the terminal has no more."""

from pathlib import Path

import pytest

from tests.cli.conftest import ROOT, Type
from tests.cli.test_help import too_wide
from workbook.cli.verdict_text import verdict_text
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import judge_recording
from workbook.exercise.source import stems
from workbook.recording.recording import Recording
from workbook.ros.tables import Table

WIDTHS = (80, 60)


@pytest.mark.parametrize("stem", stems(ROOT / "solutions"))
def test_each_verdict_fits(stem: str, monkeypatch: pytest.MonkeyPatch) -> None:
    exercise = load_exercise(stem, ROOT)
    recordings = sorted((ROOT / "tests" / "recordings" / stem).glob("*.json"))
    for path in recordings:
        judgement = judge_recording(exercise, "0", Recording.load(path))
        for columns in WIDTHS:
            monkeypatch.setenv("COLUMNS", str(columns))
            assert not too_wide(verdict_text(judgement, color=False), columns), path.name


@pytest.mark.parametrize("columns", WIDTHS)
def test_progress_fits(course: Path, typed: Type, columns: int) -> None:
    said = typed("progress", columns=columns)
    assert said.code == 0
    assert "09 · " in said.out
    assert not too_wide(said.out, columns)


def test_a_table_that_is_too_wide_is_shown_row_by_row() -> None:
    table = Table("Topics", ("topic", "type"), (("/robot/status", "std_msgs/msg/String"), ("/x", "")), "none")
    assert table.text(80) == table.text()
    assert table.text(30) == "/robot/status\n    type  std_msgs/msg/String\n/x"
