"""Memory cgroups as files of the kernel: joining one, and removing those of a slot with whatever is left in them.

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
    """Open the file by which a process joins a group. Raises OSError."""
    return os.open(joins, os.O_WRONLY | os.O_CLOEXEC)


def join(descriptor: int) -> None:
    """Move this process, which must not have other threads, into the group of an open file. Raises OSError."""
    os.write(descriptor, b"0")


def hide_group() -> None:
    """The path of its group tells a program nothing: this process sees its group as the uppermost. Raises OSError."""
    checked("unshare", libc.unshare(CLONE_NEWCGROUP))


def version_of(group: str) -> int:
    """1 or 2, by the files of a group."""
    return 2 if os.path.exists(f"{group}/cgroup.controllers") else 1


def divide_group(group: str) -> None:
    """Let the groups below one count memory, which version 2 does only when told to. Raises OSError."""
    if version_of(group) == 2:
        write(f"{group}/cgroup.subtree_control", "+memory")


def write(path: str, text: str) -> None:
    """Write to a file of the kernel, which must be there. Raises OSError."""
    descriptor = os.open(path, os.O_WRONLY)
    try:
        os.write(descriptor, text.encode())
    finally:
        os.close(descriptor)


def processes_in(group: str) -> list[int]:
    """The processes of a group; none when it is gone."""
    try:
        with open(f"{group}/{PROCESSES}") as file:
            return [int(line) for line in file]
    except OSError:
        return []


def groups_in(folder: str) -> list[str]:
    """The groups below a group; none when it is gone."""
    try:
        with os.scandir(folder) as entries:
            return [entry.path for entry in entries if entry.is_dir(follow_symlinks=False)]
    except OSError:
        return []


def remove_group(group: str, patience_s: float = LONGEST_REMOVAL_S) -> bool:
    """Kill what runs in a group and below it, and remove all of it. Returns whether it is gone."""
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
