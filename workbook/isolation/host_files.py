"""What of this machine every program needs to read, in whatever tier."""

import os
import stat
import sys
from pathlib import Path

SYSTEM_FOLDERS = ("/usr", "/lib", "/lib64", "/bin", "/sbin")
SYSTEM_FILES = ("/etc/ld.so.cache", "/etc/localtime", "/etc/alternatives")
PATH_OF_PROGRAMS = "/usr/bin:/bin"
NOT_FOR_ANSWERS = ("WORKBOOK_RUN", "XDG_CACHE_HOME")
"""Variables of the judge that would tell a program that it is being judged."""
HOST_FILES = (
    "run.py",
    "host.py",
    "libc.py",
    "tap.py",
    "student_traceback.py",
    "field_values.py",
    "missing_names.py",
)
"""What of `workbook/inside` runs in an answer's process."""
GIVEN = ("__init__.py", "models", "scenes")
"""What of the workbook an answer may import: a trained model that an exercise gives, and what it needs."""
_PACKAGE = Path(__file__).resolve().parents[1]


def interpreter_folders() -> tuple[Path, ...]:
    """Where Python, its packages, what runs an answer, and what is given to it lie; nothing of the course besides."""
    ours = (*(_PACKAGE / "inside" / name for name in HOST_FILES), *given_files())
    profile = _PACKAGE / "ros" / "loopback.xml"
    folders = {Path(sys.base_prefix).resolve(), Path(sys.prefix).resolve(), Path(sys.prefix)}
    system = tuple(Path(folder) for folder in SYSTEM_FOLDERS)
    wanted = [
        one for one in sorted(folders) if not any(one == base or base in one.parents for base in system)
    ]
    return (*wanted, *ours, profile)


def given_files() -> tuple[Path, ...]:
    """Where the part of the package `workbook` lies that an answer may import."""
    return tuple(_PACKAGE / name for name in GIVEN)


def closed_folder() -> Path | None:
    """A folder on the way to Python and its packages that other users may not enter."""
    for place in (*interpreter_folders(), Path(sys.executable), Path(sys.executable).resolve()):
        for folder in reversed(place.parents):
            if not os.stat(folder).st_mode & stat.S_IXOTH:
                return folder
    return None
