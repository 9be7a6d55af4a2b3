"""Build the students' wheel: the package with the course inside, but without solutions.

The same files always give a wheel with the same bytes. SOURCE_DATE_EPOCH sets the date of the files in the wheel.
"""

import hashlib
import os
import tempfile
import time
import zipfile
from base64 import urlsafe_b64encode
from collections.abc import Iterator
from pathlib import Path

from flit_core import buildapi

from workbook.exercise.course import IN_A_WHEEL
from workbook.exercise.source import stems
from workbook.grading.packaging import files_below
from workbook.grading.students_edition import source_for_students
from workbook.lab import bootstrap
from workbook.lab.packages import ROS
from workbook.lab.work_folder import without_outputs

NOT_FOR_STUDENTS = (
    "workbook/authoring/", "workbook/lab/lock.py", "workbook/cli/new.py", "workbook/cli/package.py",
    "workbook/grading/packaging.py", "workbook/grading/students_edition.py", "workbook/grading/gradescope_files/",
)  # fmt: skip
"""Paths in the package that only authors and instructors need."""
FOLDERS = ("lesson_nodes", "exercises/criteria", "exercises/drivers", "exercises/partners")
FILES = ("notebooks/*.ipynb", "notebooks/*.md", "exercises/*.ipynb")
PROJECT = ("pyproject.toml", "LICENSE", "LICENSE-TEXT")
DESCRIPTION = "docs/wheel.md"
LOCKED = ("build", "student")
"""Sections of the lock file that go into the wheel. Students don't install the others."""
SEARCH_PATH = "rclpy_workbook.pth"
"""This file puts the course on Python's search path, so that notebooks can import `lesson_nodes`, as in a clone."""
_FIRST_YEAR_OF_ZIP = 1980


def build_wheel(course: Path, folder: Path) -> Path:
    """Write the wheel to `folder` and return its path.

    Raises CannotPackage if the course has hidden criteria, because students could read them.
    """
    metadata = _metadata(course)
    info = next(iter(metadata)).partition("/")[0]
    files = {**dict(_package(course)), **dict(_course(course)), **metadata}
    files[SEARCH_PATH] = f"workbook/{IN_A_WHEEL}\n".encode()
    record = "".join(
        f"{name},sha256={_digest(content)},{len(content)}\n" for name, content in sorted(files.items())
    )
    files[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()
    folder.mkdir(parents=True, exist_ok=True)
    wheel = folder / f"{info.removesuffix('.dist-info')}-py3-none-any.whl"
    partial = wheel.with_name(f".{wheel.name}.part")
    with zipfile.ZipFile(partial, "w") as archive:
        for name in sorted(
            files, key=lambda one: (one.startswith(info), one)
        ):  # the wheel specification recommends putting metadata last
            entry = zipfile.ZipInfo(name, _date())
            entry.create_system = 3  # Unix, so that installers apply the permissions
            entry.external_attr = 0o100644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, files[name], compresslevel=9)
    partial.replace(wheel)
    return wheel


def ros_pins(lock: str) -> list[str]:
    """Return a requirement for each ROS package, with its locked version.

    The wheel's metadata must contain them, because pip doesn't read the lock file.
    """
    return [line for line in bootstrap.read_sections(lock)["student"] if line.startswith(ROS)]


def _package(course: Path) -> Iterator[tuple[str, bytes]]:
    for name, content in files_below(course, "workbook"):
        if not name.startswith(NOT_FOR_STUDENTS):
            yield name, content


def _course(course: Path) -> Iterator[tuple[str, bytes]]:
    inside = f"workbook/{IN_A_WHEEL}"
    for folder in FOLDERS:
        for name, content in files_below(course, folder):
            yield f"{inside}/{name}", content
    for pattern in FILES:
        for path in sorted(course.glob(pattern)):
            # Outputs would give away the predictions, so students' copies never contain them.
            text = without_outputs(path.read_text(encoding="utf-8"))
            yield f"{inside}/{path.relative_to(course).as_posix()}", text.encode()
    for stem in stems(course / "solutions"):
        yield f"{inside}/solutions/{stem}.py", source_for_students(course, stem).encode()
    sections = bootstrap.read_sections(_text(course, "requirements.lock"))
    parts = [f"#: {name}\n{bootstrap.requirements(sections, [name])}" for name in LOCKED]
    yield f"{inside}/requirements.lock", "\n".join(parts).encode()


def _metadata(course: Path) -> dict[str, bytes]:
    """Return the files of the wheel's dist-info folder, except RECORD."""
    with tempfile.TemporaryDirectory(prefix="wheel-") as scratch:
        project = Path(scratch, "project")
        (project / "workbook").mkdir(parents=True)
        for name in (*PROJECT, "workbook/__init__.py"):
            (project / name).write_bytes((course / name).read_bytes())
        (project / "README.md").write_text(_text(course, DESCRIPTION), encoding="utf-8")
        here = Path.cwd()
        os.chdir(project)  # build backends expect to run in the project's folder
        try:
            info = Path(scratch, buildapi.prepare_metadata_for_build_wheel(scratch))
        finally:
            os.chdir(here)
        files = {
            path.relative_to(scratch).as_posix(): path.read_bytes()
            for path in sorted(info.rglob("*"))
            if path.is_file()
        }
    pins = "".join(f"Requires-Dist: {pin}\n" for pin in ros_pins(_text(course, "requirements.lock")))
    name = f"{info.name}/METADATA"
    head, gap, body = files[name].decode("utf-8").partition("\n\n")
    kept = "".join(f"{line}\n" for line in head.splitlines() if not _is_for_authors(line))
    files[name] = f"{kept}{pins}\n{body if gap else ''}".encode()
    return files


def _is_for_authors(line: str) -> bool:
    """Return whether a metadata line belongs to the `dev` extra, which is useless without the tests in a checkout."""
    return line == "Provides-Extra: dev" or line.endswith(("extra == 'dev'", 'extra == "dev"'))


def _text(course: Path, name: str) -> str:
    return (course / name).read_text(encoding="utf-8")


def _digest(content: bytes) -> str:
    return urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


def _date() -> tuple[int, int, int, int, int, int]:
    moment = time.gmtime(int(os.environ.get("SOURCE_DATE_EPOCH", 0)))
    if moment.tm_year < _FIRST_YEAR_OF_ZIP:
        return (_FIRST_YEAR_OF_ZIP, 1, 1, 0, 0, 0)
    return moment[:6]
