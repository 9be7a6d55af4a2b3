"""Where the course is: its exercises, criteria and solutions. And which version of it this is."""

import hashlib
import os
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parents[1]
IN_A_WHEEL = "course"
"""Folder of the package that holds the course in a wheel. In a clone, the course surrounds the package."""
_JUDGED_WITH = (".py", ".pyi", ".xml", ".ini")
"""Code, stubs that mypy reads, the DDS profile and mypy's settings. Pictures and pages change no verdict."""


class NoCourse(RuntimeError):
    """The folder of the course was not found."""


def is_from_wheel() -> bool:
    """Whether the package was installed from a wheel, which carries the course, rather than from a clone."""
    return (_PACKAGE / IN_A_WHEEL).is_dir()


def course_folder() -> Path:
    """The folder that holds `exercises/` and `solutions/`.

    WORKBOOK_COURSE names it. Otherwise, it is the wheel's own copy, or the clone that the package was installed from.
    Raises NoCourse.
    """
    named = os.environ.get("WORKBOOK_COURSE")
    own = _PACKAGE / IN_A_WHEEL if is_from_wheel() else _PACKAGE.parent
    folder = Path(named) if named else own
    if not (folder / "exercises" / "criteria").is_dir():
        raise NoCourse(
            f"{folder} holds no exercises/criteria. Run this in the environment that `make env` made in the "
            "course's folder, or set WORKBOOK_COURSE to that folder."
        )
    return folder


def course_sha256() -> str:
    """One hash of what a judgement depends on besides the answer: the judge, the criteria, drivers and solutions."""
    course = course_folder()
    digest = hashlib.sha256()
    folders = [course / "exercises" / "criteria", course / "exercises" / "drivers", course / "solutions"]
    for label, folder in (("workbook", _PACKAGE), *((one.name, one) for one in folders)):
        for path in sorted(folder.rglob("*")):
            if path.suffix in _JUDGED_WITH and path.is_file():
                raw = path.read_bytes()
                digest.update(f"{label}/{path.relative_to(folder).as_posix()} {len(raw)}\n".encode())
                digest.update(raw)
    return digest.hexdigest()
