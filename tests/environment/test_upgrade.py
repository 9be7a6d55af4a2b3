"""An older student's copy, made by the course of November 23, 2026, is used with today's course.

In `copy_of_2026_11_23.zip`, the student had run lesson 02, added notes to lesson 05, answered exercise 09 twice (the
first answer was better), and made two predictions. Lesson 08 and exercise 08 were never opened.
"""

import json
import re
import zipfile
from pathlib import Path

import pytest

from workbook.cli.main import main
from workbook.lab import work_folder
from workbook.lesson.best_answers import best_text, hands_in_another
from workbook.lesson.progress import all_progress

ROOT = Path(__file__).resolve().parents[2]
OLDER = Path(__file__).with_name("copy_of_2026_11_23.zip")
STEM = "09_joint_positions"


@pytest.fixture
def work(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return the copy after a start with today's course. It is the current folder."""
    for name in ("exercises", "lesson_nodes", "notebooks", "solutions"):
        (tmp_path / name).symlink_to(ROOT / name)
    folder = tmp_path / "work"
    with zipfile.ZipFile(OLDER) as archive:
        archive.extractall(folder)
    monkeypatch.setenv("WORKBOOK_COURSE", str(tmp_path))
    monkeypatch.setenv("WORKBOOK_ANSWERS", "")
    monkeypatch.chdir(folder)
    assert main(["lab", "--only-copy"]) == 0
    return folder


def of_older(name: str) -> bytes:
    with zipfile.ZipFile(OLDER) as archive:
        return archive.read(name)


def text_of(path: Path) -> str:
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    return "\n".join("".join(cell["source"]) for cell in cells)


def test_every_answer_and_all_progress_stay_byte_for_byte(work: Path) -> None:
    with zipfile.ZipFile(OLDER) as archive:
        names = [
            name for name in archive.namelist() if name.startswith("answers/") and not name.endswith("/")
        ]
    assert {Path(name).parent.name for name in names} == {"answers", ".best", ".previous"}
    for name in names:
        assert (work / name).read_bytes() == of_older(name), name


@pytest.mark.parametrize("name", ["notebooks/05_timers", f"exercises/{STEM}"])
def test_a_changed_notebook_stays_and_the_new_one_is_next_to_it(name: str, work: Path) -> None:
    assert (work / f"{name}.ipynb").read_bytes() == of_older(f"{name}.ipynb")
    assert text_of(work / f"{name}.new.ipynb") == text_of(ROOT / f"{name}.ipynb")


def test_a_lesson_that_was_only_run_is_new_and_what_it_showed_is_kept(work: Path) -> None:
    assert text_of(work / "notebooks/02_nodes.ipynb") == text_of(ROOT / "notebooks/02_nodes.ipynb")
    [kept] = (work / work_folder.BACKUPS / "notebooks").glob("02_nodes.*.ipynb")
    assert kept.read_bytes() == of_older("notebooks/02_nodes.ipynb")


@pytest.mark.parametrize("folder", ["notebooks", "exercises"])
def test_what_was_never_opened_is_new(folder: str, work: Path) -> None:
    name = f"{folder}/08_humanoid_status_publisher.ipynb"
    assert text_of(work / name) == text_of(ROOT / name)
    assert not (work / name).with_suffix(".new.ipynb").exists()


def test_predictions_points_and_tries_count_as_before(work: Path, capsys: pytest.CaptureFixture[str]) -> None:
    progress = all_progress(work / "answers")
    assert progress["05_timers"].predictions == {"loop-and-timer": "c", "half-a-hertz": "a"}
    assert progress["05_timers"].outcomes_seen == ["loop-and-timer"]
    assert (progress[STEM].best, progress[STEM].tries) == (9.0, 2)
    capsys.readouterr()
    assert main(["progress"]) == 0
    assert re.search(r"^09 · .* 2 tries +9 of 10$", capsys.readouterr().out, re.MULTILINE)


def test_the_best_version_can_be_restored(work: Path) -> None:
    answers = work / "answers"
    assert hands_in_another(STEM, answers)
    assert main(["restore", STEM]) == 0
    assert (answers / f"{STEM}.py").read_text(encoding="utf-8") == best_text(STEM, answers)
    assert of_older(f"answers/{STEM}.py") in [one.read_bytes() for one in (answers / ".previous").iterdir()]


def test_the_next_start_changes_nothing(work: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = {path: path.read_bytes() for path in work.rglob("*") if path.is_file()}
    capsys.readouterr()
    assert main(["lab", "--only-copy"]) == 0
    assert capsys.readouterr().out == "Your copy in work/ is up to date.\n"
    assert {path: path.read_bytes() for path in work.rglob("*") if path.is_file()} == before
