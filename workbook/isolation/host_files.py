"""List the files on this machine that every program needs to read, whatever its isolation tier."""

import os
import stat
import sys
from pathlib import Path

SYSTEM_FOLDERS = ("/usr", "/lib", "/lib64", "/bin", "/sbin")
SYSTEM_FILES = ("/etc/ld.so.cache", "/etc/localtime", "/etc/alternatives")
PATH_OF_PROGRAMS = "/usr/bin:/bin"
NOT_FOR_ANSWERS = ("WORKBOOK_RUN", "XDG_CACHE_HOME")
"""The judge's environment variables that would reveal to a program that it's being judged."""
HOST_FILES = (
    "run.py",
    "host.py",
    "libc.py",
    "tap.py",
    "student_traceback.py",
    "field_values.py",
    "missing_names.py",
)
"""The files of `workbook/inside` that run in an answer's process."""
GIVEN = ("__init__.py", "models", "scenes")
"""The parts of the package `workbook` that an answer may import: an exercise's trained model and its modules."""
_PACKAGE = Path(__file__).resolve().parents[1]


def interpreter_folders() -> tuple[Path, ...]:
    """Return the paths of Python, its packages, the host's files, and the modules that an answer may import.

    The host is the program that loads an answer (`inside/host.py`). Of the course's other files, only the DDS profile
    is included.
    """
    ours = (*(_PACKAGE / "inside" / name for name in HOST_FILES), *given_files())
    profile = _PACKAGE / "ros" / "loopback.xml"
    folders = {Path(sys.base_prefix).resolve(), Path(sys.prefix).resolve(), Path(sys.prefix)}
    system = tuple(Path(folder) for folder in SYSTEM_FOLDERS)
    wanted = [
        one for one in sorted(folders) if not any(one == base or base in one.parents for base in system)
    ]
    return (*wanted, *ours, profile)


def given_files() -> tuple[Path, ...]:
    """Return the paths of the parts of the package `workbook` that an answer may import."""
    return tuple(_PACKAGE / name for name in GIVEN)


def closed_folder() -> Path | None:
    """Return a parent folder of a path that programs need which other users may not enter, or None if there is none."""
    for place in (*interpreter_folders(), Path(sys.executable), Path(sys.executable).resolve()):
        for folder in reversed(place.parents):
            if not os.stat(folder).st_mode & stat.S_IXOTH:
                return folder
    return None
