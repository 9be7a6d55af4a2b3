"""The commands' output fits into 80 columns, and into 60 if the terminal has no more."""

import sys
from pathlib import Path

import pytest

from tests.cli.conftest import ROOT, Type
from tests.cli.test_help import too_wide
from workbook.cli import terminal
from workbook.cli.doctor import line
from workbook.cli.verdict_text import verdict_text
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import judge_recording
from workbook.exercise.source import stems
from workbook.lab.health import HealthFinding
from workbook.recording.recording import Recording
from workbook.ros.tables import Table
from workbook.ros.tools import Broken, Edge, Graph

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


def test_an_arrow_of_the_graph_stays_on_its_line() -> None:
    edges = (Edge("/eyes", "publishes", "/robot/seen"), Edge("/brain", "subscribes", "/robot/seen"))
    graph = Graph(("/brain", "/eyes", "/idle"), {"/robot/seen": ("std_msgs/msg/String",)}, edges)
    assert graph.text(80) == str(graph)
    assert graph.text(60) == "/eyes → /robot/seen → /brain\n    std_msgs/msg/String\n/idle"


def test_an_arrow_that_brings_nothing_is_drawn_broken_with_the_reason() -> None:
    reason = "/deaf does not hear /eyes: it asks for reliable and gets best effort."
    deaf, brain = Edge("/deaf", "subscribes", "/robot/seen"), Edge("/brain", "subscribes", "/robot/seen")
    eyes, types = Edge("/eyes", "publishes", "/robot/seen"), {"/robot/seen": ("std_msgs/msg/String",)}
    broken = (Broken("/robot/seen", "/eyes", "/deaf", reason),)
    alone = Graph(("/deaf", "/eyes"), types, (deaf, eyes), broken).text(60)
    assert alone == f"/eyes → /robot/seen ✗ /deaf\n    std_msgs/msg/String\n\n✗ /robot/seen: {reason}"
    both = Graph(("/brain", "/deaf", "/eyes"), types, (brain, deaf, eyes), broken).text(60)
    assert both.startswith("/eyes → /robot/seen → /brain, ✗ /deaf\n")


@pytest.mark.parametrize("columns", WIDTHS)
def test_a_finding_of_the_doctor_fits(columns: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    finding = HealthFinding("fix", "Packages", "many packages " * 10, "install them " * 10)
    text = line(finding, sys.stdout)
    assert not too_wide(text, columns)
    first, *rest = text.splitlines()
    assert first[23:].startswith("many") and all(one.startswith(" " * 23) for one in rest)


def test_without_a_terminal_sentences_are_not_broken(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.delenv("COLUMNS", raising=False)
    terminal.say("word " * 40)
    assert capsys.readouterr().out == "word " * 40 + "\n"
