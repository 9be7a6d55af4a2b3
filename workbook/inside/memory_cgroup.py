"""Use memory cgroups through the kernel's files: join a group, or kill a group's processes and remove it.

Source: https://docs.kernel.org/admin-guide/cgroup-v1/memory.html and https://docs.kernel.org/admin-guide/cgroup-v2.html
"""

import os
import signal
import time
from contextlib import suppress

from workbook.inside.libc import checked, libc

CLONE_NEWCGROUP = 0x02000000
LONGEST_REMOVAL_S = 2.0
PROCESSES = "cgroup.procs"
_POLL_S = 0.002


def open_group(joins: str) -> int:
    """Open a group's join file, and return its descriptor. Raises OSError if it can't be opened."""
    return os.open(joins, os.O_WRONLY | os.O_CLOEXEC)


def join(descriptor: int) -> None:
    """Move this process, which must have only one thread, to the group whose join file is open (see `open_group`).

    Raises OSError.
    """
    os.write(descriptor, b"0")


def hide_group() -> None:
    """Hide the path of this process's group: from now on, the process sees its group as the root. Raises OSError."""
    checked("unshare", libc.unshare(CLONE_NEWCGROUP))


def version_of(group: str) -> int:
    """Return the cgroup version, 1 or 2, which shows in the group's files."""
    return 2 if os.path.exists(f"{group}/cgroup.controllers") else 1


def divide_group(group: str) -> None:
    """Enable memory limits for the group's subgroups, which version 2 doesn't do by default. Raises OSError."""
    if version_of(group) == 2:
        write(f"{group}/cgroup.subtree_control", "+memory")


def write(path: str, text: str) -> None:
    """Write to an existing file of the kernel. Raises OSError on failure."""
    descriptor = os.open(path, os.O_WRONLY)
    try:
        os.write(descriptor, text.encode())
    finally:
        os.close(descriptor)


def processes_in(group: str) -> list[int]:
    """Return the IDs of the processes in a group, or an empty list if the group is gone."""
    try:
        with open(f"{group}/{PROCESSES}") as file:
            return [int(line) for line in file]
    except OSError:
        return []


def groups_in(folder: str) -> list[str]:
    """Return the paths of a group's subgroups, or an empty list if the group is gone."""
    try:
        with os.scandir(folder) as entries:
            return [entry.path for entry in entries if entry.is_dir(follow_symlinks=False)]
    except OSError:
        return []


def remove_group(group: str, patience_s: float = LONGEST_REMOVAL_S) -> bool:
    """Kill all processes in a group and its subgroups, and remove the groups.

    Give up after `patience_s` seconds. Return whether the group is gone.
    """
    deadline = time.monotonic() + patience_s
    while True:
        for below in groups_in(group):
            remove_group(below, deadline - time.monotonic())
        with suppress(OSError):
            os.rmdir(group)
        if not os.path.isdir(group):
            return True
        for pid in processes_in(group):
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        if time.monotonic() >= deadline or not os.access(os.path.dirname(group), os.W_OK):
            return False
        time.sleep(_POLL_S)
