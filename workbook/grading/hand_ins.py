"""Find the answers in an instructor's files: single files, notebooks, one folder per student, or nbgrader's layout."""

import os
import re
import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbook.exercise.answers import exercises_named, means

ANSWER_SUFFIXES = (".py", ".ipynb")
ARCHIVE_SUFFIXES = (".zip", ".gz", ".tgz", ".tar", ".bz2", ".xz", ".zst", ".7z", ".rar")
SHADOWS = frozenset(
    {"conftest", "sitecustomize", "usercustomize", "setup", "rclpy", "std_msgs", "geometry_msgs"}
)
"""Names that an answer's file can't have, because it would be imported instead of the module of that name."""
_ARCHIVE = "archives are not opened: unpack it into a folder with the student's name"
SKIPPED_FOLDERS = frozenset(
    {"__pycache__", ".ipynb_checkpoints", "__MACOSX", "venv", "env", "site-packages", "node_modules"}
)
DEEPEST = 100
"""The maximum depth of nested folders to search. Real hand-ins have a few levels, but a path could have thousands."""
_LOOKS_LIKE_ONE = re.compile(r"\.(py\w?|ipynb)(?![^\W\d_])", re.IGNORECASE)
_BESIDE_OTHERS = "._"
"""The prefix of the metadata files that macOS puts next to other files."""


@dataclass(frozen=True)
class HandIn:
    """One student's answer.

    `label`: the answer's path as it's shown in results. `problem`: the reason why the answer can't be judged, or None.
    """

    student: str
    path: Path
    label: str
    problem: str | None = None


def _is_answer(path: Path) -> bool:
    return path.suffix in ANSWER_SUFFIXES and not path.name.startswith((".", "__"))


def why_no_answer(name: str) -> str | None:
    """Return why a file isn't an answer although its name looks like an answer's name.

    Return None for answers and for all other files.
    """
    path = Path(name)
    if _is_answer(path) or not _LOOKS_LIKE_ONE.search(name):
        return None
    if name.startswith(_BESIDE_OTHERS) or name == "__init__.py":
        return None
    if name.startswith("."):
        return "its name begins with a dot, so it counts as hidden: rename it"
    if name.startswith("__"):
        return "its name begins with two underscores, like the names of Python's own files: rename it"
    suffix = path.suffix
    if suffix.lower() in ANSWER_SUFFIXES:
        return f"its name ends in {suffix}, so rename it to {path.stem}{suffix.lower()}"
    shown = suffix if suffix.isprintable() and " " not in suffix else repr(suffix)
    return f"its name ends in {shown}, and not in .py or .ipynb: rename it"


def walk(top: Path) -> Iterator[tuple[str, list[str], list[str]]]:
    """Walk a folder from the top down as `os.walk` does, but safely even if the folder's content is untrusted.

    The walk goes down at most `DEEPEST` levels, skips unreadable folders, and doesn't follow links.
    """
    waiting = [(str(top), 0)]
    while waiting:
        base, depth = waiting.pop()
        try:
            with os.scandir(base) as entries:
                found = sorted(entries, key=lambda entry: entry.name)
        except OSError:
            continue
        folders = [entry.name for entry in found if _is_folder(entry)]
        links = {entry.name for entry in found if entry.is_symlink()}
        known = set(folders)
        yield base, folders, [entry.name for entry in found if entry.name not in known]
        if depth < DEEPEST:
            below = [os.path.join(base, name) for name in folders if name not in links]
            waiting += [(folder, depth + 1) for folder in reversed(below)]


def _is_folder(entry: os.DirEntry[str]) -> bool:
    try:
        return entry.is_dir()
    except OSError:  # a link to itself
        return False


def _files_below(folder: Path) -> list[Path]:
    found: list[Path] = []
    for base, folders, files in walk(folder):
        folders[:] = sorted(
            name for name in folders if name not in SKIPPED_FOLDERS and not name.startswith(".")
        )
        found += [Path(base) / name for name in sorted(files) if _is_answer(Path(name))]
    return found


def names_exercise(path: Path, stem: str) -> bool:
    """Return whether a file's name or its `%%answer` line names the exercise `stem`."""
    return _named_after(path.stem, stem) or any(means(name, stem) for name in exercises_named(path))


def _named_after(name: str, stem: str) -> bool:
    return stem.split("_", 1)[1] in re.sub(r"[^a-z0-9]+", "_", name.lower())


def hand_in_below(student: str, folder: Path, stem: str) -> HandIn:
    """Return the only answer to the exercise `stem` under `folder`, which contains all of the student's hand-ins."""
    if not folder.is_dir():
        return HandIn(student, folder, folder.name, "nothing was handed in")
    return _choose(student, folder, folder, stem)


def hand_in_named(student: str, folder: Path, stem: str) -> HandIn | None:
    """Return the answer to the exercise `stem` from a folder with several exercises' answers.

    Return None if no file is named after the exercise. The folder may also contain other files. If there's a folder
    `answers` in it, only that one is searched.
    """
    place = folder / "answers"
    if place.is_symlink():  # the link may lead to the solutions
        return HandIn(student, place, place.name, "`answers` is a symbolic link: links are not followed")
    if place.is_dir():
        folder = place
    named = [path for path in _files_below(folder) if names_exercise(path, stem)]
    if not named:
        return None
    if len(named) == 1:
        return HandIn(student, named[0], str(named[0].relative_to(folder)))
    names = ", ".join(str(path.relative_to(folder)) for path in named[:5])
    return HandIn(
        student, folder, folder.name, f"{len(named)} files could be the answer to {stem}: {names}. Leave one"
    )


def _choose(student: str, folder: Path, root: Path, stem: str) -> HandIn:
    files = [path for path in _files_below(folder) if path.stem not in SHADOWS]
    label = str(folder.relative_to(root))
    if not os.access(folder, os.R_OK | os.X_OK):
        return HandIn(student, folder, label, "the folder cannot be read")
    if not files:
        return HandIn(student, folder, label, _why_nothing(folder))
    candidates = files if len(files) == 1 else [path for path in files if names_exercise(path, stem)]
    if len(candidates) == 1:
        return HandIn(student, candidates[0], str(candidates[0].relative_to(root)))
    names = ", ".join(str(path.relative_to(folder)) for path in (candidates or files)[:5])
    return HandIn(
        student,
        folder,
        label,
        f"{len(candidates or files)} files could be the answer to {stem}: {names}. Leave one",
    )


def _why_nothing(folder: Path) -> str:
    """Return why a folder contains no answer."""
    shadows = sorted({path.name for path in _files_below(folder)})
    if shadows:
        return f"the folder holds only {', '.join(shadows)}: an answer needs a name that no ROS or Python module has"
    inside = [name for _, _, names in walk(folder) for name in names]
    packed = [name for name in sorted(inside) if name.lower().endswith(ARCHIVE_SUFFIXES)]
    if packed:
        return f"the folder holds no .py and no .ipynb file, but {packed[0]}; {_ARCHIVE}"
    for name in sorted(inside):
        reason = why_no_answer(name)
        if reason is not None:
            return f"the folder holds no .py and no .ipynb file, but {name}: {reason}"
    return "the folder holds no .py and no .ipynb file"


def _choose_in(student: str, folder: Path, root: Path, stem: str, assignment: str | None) -> HandIn:
    """Return the answer in a student's folder.

    If `assignment` is set, search only the subfolder of that name. Otherwise, if exactly one subfolder is named after
    the exercise, search that one, and if not, search the whole folder.
    """
    if assignment is not None:
        part = folder / assignment
        if part.is_symlink() or not part.is_dir():
            label = str(folder.relative_to(root))
            return HandIn(
                student, folder, label, f"there is no folder {assignment}: nothing was handed in for it"
            )
        return _choose(student, part, root, stem)
    parts = [one for one in folder.iterdir() if one.is_dir() and not one.is_symlink()]
    named = [one for one in parts if _named_after(one.name, stem)]
    return _choose(student, named[0] if len(named) == 1 else folder, root, stem)


def hand_in_root(path: Path) -> Path:
    """Return the folder that contains the hand-ins: `submitted` in nbgrader's layout, or else `path` itself."""
    return path / "submitted" if (path / "submitted").is_dir() else path


def all_hand_ins(paths: Sequence[Path], stem: str, assignment: str | None = None) -> list[HandIn]:
    """Return all answers to the exercise `stem` under `paths`, including several by the same student.

    Each student is identified by the name of a file or folder. A folder may contain files, such as `s1042.py`, or one
    folder per student with the answer anywhere in it. nbgrader's `submitted/STUDENT/ASSIGNMENT/` works, too.
    `assignment` is the exercise's name in nbgrader. If it's set, only the folder of that name is searched for each
    student. Raises FileNotFoundError if a path doesn't exist.
    """
    found: list[HandIn] = []
    for path in paths:
        if path.is_dir():
            found += _in_class(hand_in_root(path), stem, assignment)
        elif path.is_file():
            found.append(HandIn(path.stem, path, path.name))
        else:
            raise FileNotFoundError(f"there is no file or folder {path}")
    return [_as_text(hand_in) for hand_in in found]


def _in_class(root: Path, stem: str, assignment: str | None) -> Iterator[HandIn]:
    for entry in sorted(root.iterdir()):
        if entry.name.startswith(".") or entry.name in SKIPPED_FOLDERS:
            continue
        if entry.is_symlink() and (entry.is_dir() or _is_answer(entry)):
            yield HandIn(entry.stem, entry, entry.name, "a symbolic link is not an answer")
        elif entry.is_dir():
            yield _choose_in(entry.name, entry, root, stem, assignment)
        elif _is_answer(entry):
            yield HandIn(entry.stem, entry, entry.name)
        elif entry.name.lower().endswith(ARCHIVE_SUFFIXES):
            yield HandIn(entry.name.split(".")[0], entry, entry.name, _ARCHIVE)


def readable(text: str) -> str:
    """Return a file name as a string that can be stored.

    Bytes that aren't valid UTF-8 become escape sequences, so two different names never become the same string.
    """
    return os.fsencode(text).decode("utf-8", "backslashreplace")


def _as_text(raw: HandIn) -> HandIn:
    problem = None if raw.problem is None else readable(raw.problem)
    return HandIn(one_spelling(readable(raw.student)), raw.path, readable(raw.label), problem)


def one_spelling(name: str) -> str:
    """Return a name with composed accents (NFC), as most systems store it. macOS separates the accents."""
    return unicodedata.normalize("NFC", name)


def one_for_each(found: Sequence[HandIn]) -> list[HandIn]:
    """Return one hand-in per student.

    If a student has several, reject all of them, because guessing would be unfair.
    """
    by_student: dict[str, list[HandIn]] = {}
    for hand_in in found:
        by_student.setdefault(hand_in.student, []).append(hand_in)
    settled = []
    for student in sorted(by_student):
        own = by_student[student]
        if len(own) == 1:
            settled.append(own[0])
            continue
        labels = ", ".join(hand_in.label for hand_in in own)
        why = [f"{len(own)} hand-ins of one student: {labels}", *(one.problem for one in own if one.problem)]
        settled.append(HandIn(student, own[0].path, labels, ". ".join(dict.fromkeys(why))))
    return settled


def infer_exercise(paths: Sequence[Path], stems: Sequence[str]) -> list[str]:
    """Return the stems of the exercises that the files under `paths` name in their file names or `%%answer` lines."""
    files: list[Path] = []
    for path in paths:
        files += _files_below(path) if path.is_dir() else [path]
    return [stem for stem in stems if any(names_exercise(file, stem) for file in files)]
