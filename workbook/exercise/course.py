"""Locate the course (its exercises, criteria, and solutions), and identify its version."""

import hashlib
import os
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parents[1]
IN_A_WHEEL = "course"
"""In a wheel, the package's folder that contains the course. In a clone, the course surrounds the package."""
_JUDGED_WITH = (".py", ".toml", ".pyi", ".xml", ".ini")
"""The suffixes of the files that affect a judgment.

They belong to code, feedback strings, mypy stubs and settings, and the DDS profile. Figures and pages don't affect a
judgment.
"""


class NoCourse(RuntimeError):
    """Raised when the course folder isn't found."""


def is_from_wheel() -> bool:
    """Return whether the package was installed from a wheel, which includes the course, rather than from a clone."""
    return (_PACKAGE / IN_A_WHEEL).is_dir()


def course_folder() -> Path:
    """Return the folder that contains `exercises/` and `solutions/`.

    WORKBOOK_COURSE overrides the default, which is the wheel's own copy or the clone that the package was installed
    from. Raises NoCourse if the folder has no `exercises/criteria/`.
    """
    named = os.environ.get("WORKBOOK_COURSE")
    own = _PACKAGE / IN_A_WHEEL if is_from_wheel() else _PACKAGE.parent
    folder = Path(named) if named else own
    if not (folder / "exercises" / "criteria").is_dir():
        raise NoCourse(
            f"{folder} has no exercises/criteria. Run this in the environment that `make env` made in the course's "
            "folder, or set WORKBOOK_COURSE to that folder."
        )
    return folder


def course_sha256() -> str:
    """Return one hash of the files that affect a judgment except the answer: judge, criteria, drivers, solutions."""
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
