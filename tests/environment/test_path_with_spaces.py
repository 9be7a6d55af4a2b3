"""The course works in a folder with spaces, brackets, and an umlaut in its path: doctor, a lesson, and a batch."""

import csv
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from workbook.lab.bootstrap import STAMP

ROOT = Path(__file__).resolve().parents[2]
STEM = "09_joint_positions"
LESSON = "02_nodes"
LEFT_AT_HOME = shutil.ignore_patterns(
    ".git", ".venv", "work", "artifacts", "__pycache__", ".*_cache", ".hypothesis"
)

pytestmark = [pytest.mark.slow, pytest.mark.whole]


@pytest.fixture(scope="module")
def course(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Copy the course with its environment, so that its libraries are loaded from such a path."""
    place = tmp_path_factory.mktemp("elsewhere") / "my course (ä)"
    shutil.copytree(ROOT, place, ignore=LEFT_AT_HOME, symlinks=True)
    shutil.copytree(sys.prefix, place / ".venv", symlinks=True, copy_function=_link)
    [packages] = (place / ".venv" / "lib").glob("python3.*/site-packages")
    stamp = json.loads((place / ".venv" / STAMP).read_text(encoding="utf-8"))
    for path, text in (
        (packages / "workbook.pth", f"{place}\n"),
        (place / ".venv" / STAMP, json.dumps(stamp | {"root": str(place)})),
    ):
        path.unlink()  # a hard link: the original would change, too
        path.write_text(text, encoding="utf-8")
    return place


def _link(source: str, target: str) -> None:
    """Link a file if possible, because copying a gigabyte takes long."""
    try:
        os.link(source, target)
    except OSError:
        shutil.copy2(source, target)


def run(course: Path, *arguments: str) -> "subprocess.CompletedProcess[str]":
    environ = {
        name: value
        for name, value in os.environ.items()
        if not name.startswith(("PYTEST_", "WORKBOOK_", "ROS_", "VIRTUAL_ENV", "LD_LIBRARY_PATH", "_ROS"))
    }
    command = [str(course / ".venv" / "bin" / "python"), *arguments]
    done = subprocess.run(command, cwd=course, env=environ, capture_output=True, text=True, check=False)
    assert "Traceback" not in done.stdout + done.stderr, done.stdout + done.stderr
    return done


def test_the_packages_come_from_there(course: Path) -> None:
    found = run(course, "-c", "import rclpy, workbook; print(rclpy.__file__, workbook.__file__, sep='\\n')")
    assert all(line.startswith(str(course)) for line in found.stdout.splitlines()), found


def test_the_doctor_finds_the_machine_ready(course: Path) -> None:
    done = run(course, "-m", "workbook.cli.main", "doctor")
    assert done.returncode == 0, done.stdout + done.stderr


def test_a_lesson_shows_what_is_committed(course: Path) -> None:
    done = run(course, "-m", "workbook.authoring", "compare", LESSON)
    assert done.returncode == 0, done.stdout


def test_a_batch_is_graded(course: Path, tmp_path: Path) -> None:
    answers = tmp_path / "the answers (ö)"
    answers.mkdir()
    shutil.copy(course / "solutions" / f"{STEM}.py", answers / "ada.py")
    out = tmp_path / "the results"
    done = run(
        course, "-m", "workbook.cli.main", "grade", str(answers), "--exercise", STEM, "--out", str(out),
        "--isolation", "limits",
    )  # fmt: skip
    assert done.returncode == 0, done.stdout + done.stderr
    with (out / "grades.csv").open(encoding="utf-8-sig", newline="") as file:
        assert [(row["student"], row["score"]) for row in csv.DictReader(file)] == [("ada", "10")]
