"""`workbook hint`: each call shows one more hint, and the number is stored with the rest of the progress."""

from pathlib import Path

import pytest

from tests.cli.conftest import ROOT, Type
from tests.cli.test_help import too_wide
from workbook.cli.hint import as_terminal_text
from workbook.exercise.source import load, stems
from workbook.lesson.progress import all_progress


def shown(course: Path) -> int:
    return all_progress(course / "work" / "answers")["09_joint_positions"].hints


def test_each_time_one_hint_more_is_shown(course: Path, typed: Type) -> None:
    for number, name in enumerate(("nudge", "pointer", "sketch"), 1):
        said = typed("hint", "09")
        assert said.code == 0
        assert f"Hint {number} of 3, a {name}" in said.out
        assert said.out.count("Hint ") == number
        assert shown(course) == number
    assert "That was the last hint." in said.out
    assert "Hint 3 of 3" in typed("hint", "joint_positions").out


@pytest.mark.parametrize("level", ["2", "pointer"])
def test_a_hint_may_be_named(course: Path, typed: Type, level: str) -> None:
    said = typed("hint", "09", level)
    assert "Hint 2 of 3, a pointer" in said.out
    assert "Hint 3" not in said.out
    typed("hint", "09", "1")
    assert shown(course) == 2, "an earlier hint takes nothing back"


def test_a_hint_that_there_is_not(course: Path, typed: Type) -> None:
    said = typed("hint", "09", "4")
    assert said.code == 2
    assert "there is no hint 4. The hints are 1 (nudge), 2 (pointer), and 3 (sketch)" in " ".join(
        said.err.split()
    )


@pytest.mark.parametrize("place", [".", "work", "work/notebooks"])
def test_it_does_not_matter_where_one_stands(
    course: Path, typed: Type, place: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(course / place)
    assert typed("hint", "09").code == 0
    assert shown(course) == 1
    assert not (course / "answers").exists()


@pytest.mark.parametrize("stem", stems(ROOT / "solutions"))
@pytest.mark.parametrize("columns", [80, 60])
def test_prose_fits_and_code_is_as_it_was(stem: str, columns: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    for hint in load(ROOT / "solutions" / f"{stem}.py").hints:
        text = as_terminal_text(hint)
        prose = "\n".join(line for line in text.splitlines() if not line.startswith("    "))
        assert not too_wide(prose, columns)
        assert "```" not in text and "](" not in text and "**" not in prose
        for line in "".join(hint.split("```")[1::2]).splitlines()[1:]:
            assert f"    {line}".rstrip() in text
