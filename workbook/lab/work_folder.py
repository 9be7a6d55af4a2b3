"""Update the student's copy of the lessons: add new ones, and never overwrite changed ones.

In a clone, the copy is `work/`. Its notebooks are copied without outputs, which would give away predictions. The
committed notebooks keep their outputs.
"""

import hashlib
import json
import os
import platform
import re
import shutil
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path

FOLDERS = ("notebooks", "exercises")
STATE = Path(".state", "delivered.json")
"""The file that lists the versions delivered to the student.

If a notebook doesn't match any of them, the student has changed it.
"""
BACKUPS = Path(".state", "backups")
ANSWERS = "answers"


@dataclass
class WorkFolderUpdate:
    """The changes of one update, as paths below `folder`, the student's copy."""

    folder: str = "work"
    added: list[str] = field(default_factory=list)
    upgraded: list[str] = field(default_factory=list)
    beside: list[tuple[str, str]] = field(default_factory=list)  # (the student's file, the new version)

    def lines(self) -> list[str]:
        """Return the messages for the student, one line each, or an empty list if nothing changed."""
        said = []
        if self.added:
            said.append(f"Added {_count(len(self.added), 'notebook')} to {self.folder}/.")
        if self.upgraded:
            said.append(f"Updated {_count(len(self.upgraded), 'notebook')} that you had not changed.")
        for own, new in self.beside:
            said.append(
                f"There is a new version of {self.folder}/{own}. Yours stays as it is; "
                f"the new one is {self.folder}/{new}."
            )
        return said


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def fingerprint(path: Path) -> str:
    """Hash the types and sources of a notebook's cells, but not outputs or metadata.

    So running a lesson doesn't change its fingerprint. For a file that isn't a notebook, hash the whole content.
    """
    content = path.read_bytes()
    try:
        cells = [
            (cell["cell_type"], _joined(cell["source"]))
            for cell in json.loads(content.decode("utf-8"))["cells"]
        ]
    except (ValueError, KeyError, TypeError):
        return hashlib.sha256(content).hexdigest()
    return hashlib.sha256(json.dumps(cells).encode()).hexdigest()


def _joined(source: object) -> str:
    return "".join(source) if isinstance(source, list) else str(source)


def read_state(work: Path) -> dict[str, list[str]]:
    """Load the fingerprints of each file's delivered versions, oldest first, keyed by the file's path below `work/`."""
    try:
        state = json.loads((work / STATE).read_text(encoding="utf-8"))
        return {str(name): [str(mark) for mark in marks] for name, marks in state.items()}
    except (OSError, ValueError, AttributeError, TypeError):
        return {}


def update_work_folder(root: Path, work: Path) -> WorkFolderUpdate:
    """Update `work/` with the lessons and exercises below `root`."""
    state = read_state(work)
    report = WorkFolderUpdate(work.name)
    for source in lessons(root):
        name = source.relative_to(root).as_posix()
        own = work / name
        marks = state.setdefault(name, [])
        new = fingerprint(source)
        if not own.exists():
            _copy(source, own)
            report.added.append(name)
        elif (present := fingerprint(own)) == new:
            if own.read_text(encoding="utf-8") in _earlier_copies(source):
                _copy(source, own)
        elif present in marks:
            keep_backup(work, own)
            _copy(source, own)
            report.upgraded.append(name)
        elif new not in marks:
            beside = own.with_name(f"{own.stem}.new{own.suffix}")
            if beside.exists() and fingerprint(beside) not in marks:
                keep_backup(work, beside)
            _copy(source, beside)
            report.beside.append((name, beside.relative_to(work).as_posix()))
        if new in marks:
            marks.remove(new)
        marks.append(new)
    for page in [*sorted((root / "notebooks").glob("*.md")), *sorted((root / "lesson_nodes").glob("*.py"))]:
        _copy(page, work / page.relative_to(root))  # students only read these files
    (work / ANSWERS).mkdir(parents=True, exist_ok=True)
    _write(work / STATE, json.dumps(state, indent=1, sort_keys=True) + "\n")
    return report


def lessons(root: Path) -> list[Path]:
    """Return the notebooks: lessons first, then exercises, in course order."""
    return [path for folder in FOLDERS for path in sorted((root / folder).glob("[0-9]*.ipynb"))]


def first_lesson(root: Path) -> str | None:
    """Return the path below `work/` of the lesson to open, or None if there are no lessons."""
    found = lessons(root)
    return found[0].relative_to(root).as_posix() if found else None


def keep_backup(work: Path, path: Path) -> Path:
    """Copy a student's file to a dated name that nothing overwrites, and return the copy's path."""
    folder = work / BACKUPS / path.relative_to(work).parent
    stamp = time.strftime("%Y-%m-%d_%H-%M-%S")
    kept = folder / f"{path.stem}.{stamp}{path.suffix}"
    number = 2
    while kept.exists():
        kept = folder / f"{path.stem}.{stamp}-{number}{path.suffix}"
        number += 1
    kept.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy2(path, kept)
    return kept


def without_outputs(text: str) -> str:
    """Remove outputs and execution counts from a notebook's text. If there are none, return the text unchanged."""
    try:
        notebook = json.loads(text)
        ran = [one for one in notebook["cells"] if one.get("outputs") or one.get("execution_count")]
    except (ValueError, KeyError, TypeError, AttributeError):
        return text
    for cell in ran:
        cell |= {"outputs": [], "execution_count": None}
    return json.dumps(notebook, indent=1, ensure_ascii=False) + "\n" if ran else text


def with_language_version(text: str) -> str:
    """Add the Python version to a notebook's metadata, as a kernel would, so that opening it changes nothing."""
    try:
        notebook = json.loads(text)
        notebook["metadata"]["language_info"]["version"] = platform.python_version()
    except (ValueError, KeyError, TypeError):
        return text
    return json.dumps(notebook, indent=1, ensure_ascii=False) + "\n"


def _earlier_copies(source: Path) -> set[str]:
    """Return a notebook's text in the two forms that earlier course versions copied: unchanged, or without outputs."""
    text = source.read_text(encoding="utf-8")
    return {text, without_outputs(text)}


def _copy(source: Path, target: Path) -> None:
    text = source.read_text(encoding="utf-8")
    if source.suffix == ".ipynb":
        text = with_language_version(without_outputs(text))
    if not target.is_file() or target.read_bytes() != text.encode():
        _write(target, text)


def _write(target: Path, text: str) -> None:
    """Write atomically, so that a full disk or an interruption leaves the old file intact."""
    target.parent.mkdir(parents=True, exist_ok=True)
    handle, name = tempfile.mkstemp(dir=target.parent, prefix=".", suffix=".part")
    try:
        with os.fdopen(handle, "w", encoding="utf-8") as stream:
            stream.write(text)
        Path(name).chmod(0o644)
        Path(name).replace(target)
    except BaseException:
        Path(name).unlink(missing_ok=True)
        raise


class NoSuchExercise(LookupError):
    """Raised when no exercise has the given name. The message lists the existing exercises."""


def find_exercise(root: Path, name: str) -> str:
    """Find an exercise by its stem (09_joint_positions), slug (joint_positions), or number (9), and return its stem."""
    stems = [path.stem for path in lessons(root) if path.parent.name == "exercises"]
    wanted = re.sub(r"\.(ipynb|py)$", "", name.strip()).rpartition("/")[2]
    for stem in stems:
        number, _, slug = stem.partition("_")
        if wanted in (stem, slug, number) or (
            wanted.isdigit() and number.isdigit() and int(wanted) == int(number)
        ):
            return stem
    known = ", ".join(stems) or "none yet"
    raise NoSuchExercise(f"There is no exercise {name!r}. The exercises are: {known}.")


def reset(root: Path, work: Path, name: str) -> tuple[str, list[Path]]:
    """Reset an exercise to a fresh notebook without an answer file.

    Return the exercise's stem and the backups of the student's files. Raise NoSuchExercise if the name is unknown.
    """
    stem = find_exercise(root, name)
    notebook = work / "exercises" / f"{stem}.ipynb"
    answer = work / ANSWERS / f"{stem}.py"
    kept = [keep_backup(work, path) for path in (notebook, answer) if path.exists()]
    source = root / "exercises" / f"{stem}.ipynb"
    _copy(source, notebook)
    answer.unlink(missing_ok=True)
    state = read_state(work)
    marks = [mark for mark in state.get(f"exercises/{stem}.ipynb", []) if mark != fingerprint(source)]
    state[f"exercises/{stem}.ipynb"] = [*marks, fingerprint(source)]
    _write(work / STATE, json.dumps(state, indent=1, sort_keys=True) + "\n")
    return stem, kept
