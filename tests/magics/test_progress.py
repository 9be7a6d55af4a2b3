"""What `%progress` stores about a student, and what it shows."""

import json
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

from workbook.lesson import activity
from workbook.lesson.activity import StudyPace, note_cell
from workbook.lesson.predictions import predict
from workbook.lesson.progress import (
    LessonProgress,
    all_progress,
    changed_progress,
    load_progress,
    save_progress,
)
from workbook.magics.progress_table import progress_table

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("WORKBOOK_ANSWERS", str(tmp_path))
    monkeypatch.setenv("JPY_SESSION_NAME", f"/home/ada/work/notebooks/{STEM}.ipynb")
    monkeypatch.setattr(activity, "_pace", StudyPace())
    return tmp_path


def ran(cell: str | None) -> SimpleNamespace:
    return SimpleNamespace(info=SimpleNamespace(cell_id=cell))


def cells_of(stem: str) -> list[str]:
    notebook = json.loads((ROOT / "notebooks" / f"{stem}.ipynb").read_text(encoding="utf-8"))
    return [cell["id"] for cell in notebook["cells"] if cell["cell_type"] == "code"]


def test_cells_and_predictions_are_noted_once(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for cell in ("run-it-1", "run-it-2", "run-it-1", None):
        note_cell(ran(cell))
    predict("b", about="the rate")
    predict("c", about="the rate")
    predict("...", about="the joints")
    kept = load_progress(STEM)
    assert kept.cells == ["run-it-1", "run-it-2"]
    assert kept.predictions == {"the rate": "c"}


@pytest.mark.parametrize("name", ["", "notebooks/Untitled.ipynb", f"exercises/{STEM}.ipynb", "python"])
def test_nothing_is_noted_outside_of_a_lesson(
    folder: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.setenv("JPY_SESSION_NAME", name)
    note_cell(ran("run-it-1"))
    predict("b", about="the rate")
    assert list(folder.iterdir()) == []


def test_the_table_tells_what_was_done(folder: Path) -> None:
    cells = cells_of(STEM)
    save_progress(
        STEM,
        LessonProgress(tries=3, best=7.5, read=[*cells[: len(cells) // 2], "a-cell-of-an-older-version"]),
    )
    save_progress("08_humanoid_status_publisher", LessonProgress(tries=1, best=10.0, solved=True))
    save_progress("00_start_here", LessonProgress(read=cells_of("00_start_here")))
    found = {row.title: row for row in progress_table(ROOT).rows}
    nine = next(row for title, row in found.items() if title.startswith("09"))
    eight = next(row for title, row in found.items() if title.startswith("08"))
    zero = next(row for title, row in found.items() if title.startswith("00"))
    assert nine.read == f"{round(100 * (len(cells) // 2) / len(cells))} %"
    assert (nine.exercise, nine.score) == ("3 tries", "7.5 of 10")
    assert (eight.exercise, eight.score) == ("✓ solved", "10 of 10")
    assert (zero.read, zero.exercise, zero.score) == ("✓ all", "", "")
    lessons = [title for title in found if "· Deeper:" not in title]
    assert len(lessons) < len(found)
    assert f"1 of {len(lessons)} lessons read" in progress_table(ROOT).summary


def test_the_first_thing_not_done_is_named_and_all_done_is_praised(folder: Path) -> None:
    assert "00" in progress_table(ROOT).next_step
    for path in (ROOT / "notebooks").glob("[0-9]*.ipynb"):
        if path.stem.endswith("_deeper"):
            continue  # optional
        save_progress(path.stem, LessonProgress(tries=1, solved=True, best=10.0, read=cells_of(path.stem)))
    assert "the whole course" in progress_table(ROOT).next_step


def test_the_page_is_escaped_and_the_text_is_aligned(folder: Path) -> None:
    shown = progress_table(ROOT)
    page = shown._repr_html_()
    assert page.count("<tr>") == len(shown.rows) + 1
    lines = str(shown).splitlines()
    assert lines[0].startswith("lesson") and lines[0].endswith("points")


def test_what_another_version_wrote_survives(folder: Path) -> None:
    entry = {"tries": 2, "best": 4, "solved": "perhaps", "stars": 5}
    (folder / ".progress.json").write_text(json.dumps({STEM: entry, "11_broken": 7}))
    assert load_progress(STEM) == LessonProgress(tries=2, best=4)
    assert all_progress()["11_broken"] == LessonProgress()
    with changed_progress(STEM) as progress:
        progress.hints = 1
    stored = json.loads((folder / ".progress.json").read_text())
    assert stored[STEM]["stars"] == 5
    assert stored[STEM]["hints"] == 1


ADD = """
import sys
from workbook.lesson.progress import changed_progress
for number in range(40):
    with changed_progress("09_joint_positions") as progress:
        progress.cells.append(f"{sys.argv[1]}-{number}")
"""


def test_two_notebooks_at_once_lose_nothing(folder: Path) -> None:
    started = [subprocess.Popen([sys.executable, "-c", ADD, name]) for name in ("left", "right", "head")]
    assert [one.wait() for one in started] == [0, 0, 0]
    assert len(set(load_progress(STEM).cells)) == 120


def test_the_command_shows_the_table(folder: Path) -> None:
    save_progress(STEM, LessonProgress(tries=1, best=2.0))
    command = [str(Path(sys.executable).with_name("workbook")), "progress"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert "2 of 10" in done.stdout
    assert "lessons read" in done.stdout


def test_a_file_to_hand_in_that_is_not_the_best_version_is_named(folder: Path) -> None:
    (folder / ".best").mkdir()
    (folder / ".best" / f"{STEM}.py").write_text("robot = 'best'\n")
    (folder / f"{STEM}.py").write_text("robot = 'best'  \n")
    assert "best version" not in str(progress_table(ROOT))
    (folder / f"{STEM}.py").write_text("robot = 'worse'\n")
    warning = (
        f"{STEM}: the file to hand in is not your best version. To restore your best one, run %restore 09"
    )
    assert warning in str(progress_table(ROOT))
    assert warning in progress_table(ROOT)._repr_html_()
