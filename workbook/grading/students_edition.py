"""Write the students' edition: the course without solutions, example answers, and the instructors' pages."""

import hashlib
import json
import re
import zipfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from workbook.exercise.definition import load_exercise
from workbook.exercise.source import stems
from workbook.exercise.without_solution import without_solution
from workbook.grading.packaging import GRADESCOPE_FILES, CannotPackage, files_below

MANIFEST = ".edition.json"
"""The name of the file with the hashes of all files in the edition, by which a later run recognizes them."""
PAGES = ("README.md", "environment.md", "docs/commands.md")
"""Pages with passages for instructors only, which are marked by comments (see `for_students`)."""
KEPT = (
    "LICENSE", "LICENSE-TEXT", "pyproject.toml", "requirements.lock", "conftest.py", ".gitignore", ".gitattributes",
)  # fmt: skip
FOLDERS = ("workbook", "lesson_nodes", "exercises/criteria", "exercises/drivers", "exercises/partners")
NOT_FOR_STUDENTS = "workbook/authoring/site/"
"""The package for the website, which needs pages that the students' edition doesn't have."""
FILES = (
    "notebooks/*.ipynb",
    "notebooks/*.md",
    "exercises/*.ipynb",
    "docs/*.png",
    "docs/wheel.md",
    ".vscode/*.json",
)
TARGETS = ("help", "env", "lab", "progress", "test", "clean")
"""The Makefile targets that students need."""
ITS_OWN = {"tests/test_course.py": "course_tests.txt", "solutions/README.md": "solutions.md"}
"""Maps each file that exists only in the students' edition to the file with its content."""
_INSTRUCTORS = re.compile(r"<!-- for instructors -->\n.*?<!-- end of for instructors -->\n\n?", re.DOTALL)
_LINE = re.compile(r".*<!-- for instructors -->.*\n")
_IN_MAKEFILE = {
    "--extras dev,farm,similar": "--extras dev",
    "tests/run.py $(ARGS)": "-m pytest --nbval tests notebooks $(ARGS)",
    "test the core (ARGS='--only pytest' for a part)": "check that everything works here",
}
_TARGET = re.compile(r"^([a-z-]+):", re.MULTILINE)
_EPOCH = (1980, 1, 1, 0, 0, 0)


@dataclass(frozen=True)
class Edition:
    """The files of the edition. `removed`: the files of an earlier edition that this edition no longer has."""

    files: tuple[str, ...]
    removed: tuple[str, ...] = ()


def students_edition(course: Path, target: Path) -> Edition:
    """Write the students' edition of a course to the folder `target`, or to a zip file if `target` ends with .zip.

    If the folder contains an earlier edition, perhaps with its Git history, that edition is updated. For the same
    course, the bytes are always the same. Raises CannotPackage if the folder contains other files, or if a file of the
    earlier edition was changed by hand. It's also raised if the course has hidden criteria, because students could read
    them.
    """
    files = dict(_files(course))
    if target.suffix == ".zip":
        _zip(files, target)
        return Edition(tuple(sorted(files)))
    return _into(files, target)


def for_students(text: str) -> str:
    """Return a page without the passages for instructors.

    A passage for instructors is between the markers `<!-- for instructors -->` and `<!-- end of for instructors -->`,
    each on a separate line. A single line, such as a table row, is also removed if it contains the first marker.
    """
    return _LINE.sub("", _INSTRUCTORS.sub("", text))


def _files(course: Path) -> Iterator[tuple[str, bytes]]:
    for name in KEPT:
        yield name, (course / name).read_bytes()
    for name in PAGES:
        yield name, for_students((course / name).read_text(encoding="utf-8")).encode()
    yield "Makefile", _makefile((course / "Makefile").read_text(encoding="utf-8")).encode()
    for folder in FOLDERS:
        yield from (one for one in files_below(course, folder) if not one[0].startswith(NOT_FOR_STUDENTS))
    for pattern in FILES:
        for path in sorted(course.glob(pattern)):
            yield path.relative_to(course).as_posix(), path.read_bytes()
    for stem in stems(course / "solutions"):
        yield f"solutions/{stem}.py", source_for_students(course, stem).encode()
    for name, own in ITS_OWN.items():
        yield name, (GRADESCOPE_FILES / "students" / own).read_bytes()


def source_for_students(course: Path, stem: str) -> str:
    """Return an exercise's source with its starter and hints, but without its solution.

    Raises CannotPackage if the exercise has a hidden criterion in the course's folder.
    """
    exercise = load_exercise(stem, course)
    # Criteria in the instructor's own folder are never copied, but a hidden criterion in the course's folder would be.
    if any(one.hidden for one in exercise.criteria if one.title in _criteria_text(course, stem)):
        raise CannotPackage(
            f"exercises/criteria/{stem}.py has a hidden criterion, and students could read it. "
            "Put it into your own folder, and name that folder with --criteria when you grade"
        )
    return without_solution(exercise.source, hints=True)


def _criteria_text(course: Path, stem: str) -> str:
    return (course / "exercises" / "criteria" / f"{stem}.py").read_text(encoding="utf-8")


def _makefile(text: str) -> str:
    """Reduce the Makefile to the students' targets, and make `make test` run the edition's tests."""
    begins = [match.start() for match in _TARGET.finditer(text)]
    head, *targets = (text[a:b] for a, b in zip([0, *begins], [*begins, len(text)], strict=True))
    kept = [one for one in targets if one.partition(":")[0] in TARGETS]
    made = head + "".join(kept)
    phony = re.sub(r"^\.PHONY:.*$", f".PHONY: {' '.join(TARGETS)}", made, flags=re.MULTILINE)
    for ours, theirs in _IN_MAKEFILE.items():
        phony = phony.replace(ours, theirs)
    return phony


def _zip(files: dict[str, bytes], target: Path) -> None:
    target.parent.mkdir(parents=True, exist_ok=True)
    partial = target.with_name(f".{target.name}.part")
    with zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name in sorted(files):
            entry = zipfile.ZipInfo(f"{target.stem}/{name}", _EPOCH)
            entry.create_system = 3  # Unix; otherwise, the permissions are ignored
            entry.external_attr = 0o100644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, files[name])
    partial.replace(target)


def _into(files: dict[str, bytes], folder: Path) -> Edition:
    before = _earlier(folder)
    changed = [
        name
        for name, digest in before.items()
        if (folder / name).is_file()
        and _digest((folder / name).read_bytes()) not in (digest, _digest(files.get(name)))
    ]
    if changed:
        raise CannotPackage(
            f"changed by hand since the last edition: {', '.join(sorted(changed)[:5])}. "
            "Move your changes elsewhere, or write the edition into another folder"
        )
    removed = tuple(sorted(name for name in before if name not in files and (folder / name).is_file()))
    for name in removed:
        (folder / name).unlink()
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.is_file() or path.read_bytes() != content:
            path.write_bytes(content)
    manifest = {name: _digest(content) for name, content in sorted(files.items())}
    (folder / MANIFEST).write_text(json.dumps(manifest, indent=1) + "\n", encoding="utf-8")
    return Edition(tuple(sorted(files)), removed)


def _earlier(folder: Path) -> dict[str, str]:
    """Return the hashes of the files that an earlier run wrote, keyed by file name, or {} for a new folder."""
    if not folder.exists() or not any(one.name != ".git" for one in folder.iterdir()):
        return {}
    try:
        content = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))
        inside = folder.resolve()
        return {
            str(name): str(digest)
            for name, digest in content.items()
            if (folder / name).resolve().is_relative_to(inside)
        }
    except (OSError, ValueError, AttributeError) as error:
        raise CannotPackage(
            f"{folder} holds files that are not part of a students' edition. Name a new folder, or an earlier edition"
        ) from error


def _digest(content: bytes | None) -> str:
    return "" if content is None else hashlib.sha256(content).hexdigest()
