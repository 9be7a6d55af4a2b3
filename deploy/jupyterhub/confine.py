"""Build the command that confines a student's server to the course and the student's own folders."""

import importlib.util
import sys
from collections.abc import Sequence
from pathlib import Path

from deploy.jupyterhub.places import ANSWERS, FEEDBACK, HAND_INS, PUBLISHED, Place
from workbook.exercise.course import is_from_wheel
from workbook.isolation.bubblewrap import system_files

HIDDEN = frozenset({"artifacts", "build", "dist", "tests", "work"})
"""Folders of a clone that are hidden from servers. Names that begin with a dot are hidden, too."""
SETTINGS = ("/etc/hosts", "/etc/nsswitch.conf", "/etc/fonts", "/etc/ssl/openssl.cnf")
EXCHANGE = Path("/srv/nbgrader/exchange")
"""nbgrader's default exchange folder."""
_OOM = "echo 300 > /proc/self/oom_score_adj"
"""If the machine runs out of memory, Linux ends a student's server before the hub, which has 0 (proc(5)).

Kernels have 600, so they end first.
"""
_AS_STUDENT = f'{_OOM} && umask 027 && exec "$@"'
"""Runs a student's server. New files are readable only by their owner and group.

For hand-ins, that's the group of the instructors.
"""
_AS_INSTRUCTOR = f'mount -t proc proc /proc && {_OOM} && umask 022 && exec "$@"'
"""Runs an instructor's server, which needs nested sandboxes.

The kernel allows a nested sandbox its own /proc only if this sandbox's /proc is fully visible.
"""


def home_of(name: str) -> str:
    """Return the path of a user's home folder inside the sandbox."""
    return f"/home/{name}"


def work_inside(place: Place, course: Path) -> Path:
    """Return the path of the work folder inside the sandbox, where `workbook lab` looks for it."""
    return Path(home_of(place.name)) / "work" if is_from_wheel() else course / "work"


def confined(
    command: Sequence[str],
    place: Place,
    *,
    course: Path,
    memory_folders: int,
    is_instructor: bool = False,
    services: Sequence[Path] = (),
) -> list[str]:
    """Wrap `command` to run as the user of `place`, with separate files and processes. Root must start the result.

    `memory_folders`: the size of /tmp and of /dev/shm, in bytes each. An instructor can also read all hand-ins, publish
    pages, and run answers in a sandbox. `services`: folders with the sockets of services that students may use.
    """
    line = [
        *("bwrap", "--unshare-pid", "--unshare-ipc", "--unshare-uts", "--unshare-cgroup-try"),
        *("--die-with-parent", "--new-session", "--hostname", "class", "--proc", "/proc", "--dev", "/dev"),
    ]
    for folder in ("/tmp", "/dev/shm"):
        line += ["--perms", "1777", "--size", str(memory_folders), "--tmpfs", folder]
    for folder in ("/etc", "/run"):  # a sandbox within this one covers /run
        line += ["--perms", "0755", "--dir", folder]
    line += system_files()
    for file in SETTINGS:
        line += ["--ro-bind-try", file, file]
    for part in (Path(sys.base_prefix).resolve(), Path(sys.prefix), *_parts(course)):
        if not part.is_relative_to("/usr"):
            line += [*_way_to(part), "--ro-bind", str(part), str(part)]
    work = work_inside(place, course)
    written = {place.home: Path(home_of(place.name)), place.work: work, place.hand_ins: work / ANSWERS}
    read = {place.published: work / FEEDBACK, place.passwd: Path("/etc/passwd")}
    read |= {folder: folder for folder in services}
    if is_instructor:
        written[place.top / PUBLISHED] = work / PUBLISHED
        read[place.top / HAND_INS] = work / HAND_INS
    if importlib.util.find_spec("nbgrader") and EXCHANGE.is_dir():
        written[EXCHANGE] = EXCHANGE
    for option, folders in (("--bind", written), ("--ro-bind", read)):
        for outside, inside in folders.items():
            line += [*_way_to(inside), option, str(outside), str(inside)]
    shell = _AS_INSTRUCTOR if is_instructor else _AS_STUDENT
    line += ["--remount-ro", "/", "--chdir", str(work), "--", "/bin/sh", "-c", shell, "sh"]
    ids = [f"--reuid={place.user}", f"--regid={place.user}"]
    groups = f"--groups={place.instructors}" if is_instructor else "--clear-groups"
    return [
        *line,
        "setpriv",
        *ids,
        groups,
        "--inh-caps=-all",
        "--bounding-set=-all",
        "--no-new-privs",
        *command,
    ]


def _way_to(path: Path) -> list[str]:
    """Return the bubblewrap options that create the parents of `path` with mode 0755.

    Without them, bubblewrap would let no other user into the parents if only its owner may enter `path`.
    """
    return [word for folder in [*path.parents][-2::-1] for word in ("--perms", "0755", "--dir", str(folder))]


def _parts(course: Path) -> list[Path]:
    if is_from_wheel():
        return []
    return [part for part in sorted(course.iterdir()) if part.name not in HIDDEN and part.name[0] != "."]
