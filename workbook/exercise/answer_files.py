"""Find the student's answer files, and save a cell to one without losing the previous version."""

import os
from dataclasses import dataclass
from pathlib import Path

ANSWERS = "answers"
KEPT_VERSIONS = 50
"""The most earlier versions kept of one answer: enough for an afternoon of changes, at a few kilobytes each."""


def answers_folder() -> Path:
    """Return the answers' folder: WORKBOOK_ANSWERS, or `answers/` in the student's work folder or the current one."""
    named = os.environ.get("WORKBOOK_ANSWERS")
    if named:
        return Path(named)
    here = Path.cwd()
    for folder in (here, *here.parents):
        if (folder / ".state").is_dir() or (folder / ANSWERS).is_dir():
            return folder / ANSWERS
    return here / ANSWERS


def answer_file(stem: str) -> Path:
    """Return the path of the student's answer to an exercise, whether or not it exists."""
    return answers_folder() / f"{stem}.py"


@dataclass(frozen=True)
class Saved:
    """The result of saving a cell. `outcome`: "new", "changed", "unchanged", or "refused" (the cell is the starter)."""

    path: Path
    outcome: str
    previous: Path | None = None


def same_program(one: str, other: str) -> bool:
    """Return whether two programs differ at most in trailing spaces, and in blank lines at the beginning and end."""
    return [line.rstrip() for line in one.strip().splitlines()] == [
        line.rstrip() for line in other.strip().splitlines()
    ]


def _put_aside(path: Path) -> Path:
    folder = path.parent / ".previous"
    folder.mkdir(exist_ok=True)
    kept = sorted(folder.glob(f"{path.stem}.[0-9][0-9][0-9][0-9].py"))
    number = int(kept[-1].suffixes[-2][1:]) + 1 if kept else 1
    aside = folder / f"{path.stem}.{number:04d}.py"
    aside.write_bytes(path.read_bytes())
    for old in kept[: -KEPT_VERSIONS + 1]:
        old.unlink()
    return aside


def save_answer(stem: str, text: str, starter: str) -> Saved:
    """Write a cell to its answer file, and keep the previous version in `.previous/`.

    A cell that contains the unchanged starter never replaces an answer that differs from it.
    """
    path = answer_file(stem)
    path.parent.mkdir(parents=True, exist_ok=True)
    text = text if text.endswith("\n") else text + "\n"
    if not path.exists():
        _write(path, text)
        return Saved(path, "new")
    current = path.read_text(encoding="utf-8", errors="replace")
    if same_program(current, text):
        os.utime(path)  # the file's time records when the student last ran it
        return Saved(path, "unchanged")
    if same_program(text, starter):
        return Saved(path, "refused")
    previous = _put_aside(path)
    _write(path, text)
    return Saved(path, "changed", previous)


def _write(path: Path, text: str) -> None:
    partial = path.with_suffix(".part")
    partial.write_text(text, encoding="utf-8")
    partial.replace(path)


def replace_answer(stem: str, text: str, folder: Path | None = None) -> Saved:
    """Replace an answer, for example with the starter or an earlier version. The replaced one moves to `.previous/`."""
    path = (folder or answers_folder()) / f"{stem}.py"
    path.parent.mkdir(parents=True, exist_ok=True)
    previous = _put_aside(path) if path.exists() else None
    _write(path, text)
    return Saved(path, "changed", previous)
