"""Create a memory cgroup for a grading process, and remove the group when that process exits or is killed.

    python -I -S run.py group_keeper FOLDER PREFIX

This process creates a group in FOLDER and prints the group's path, or an error. Then it waits until its standard input
is closed by the grading process or, if that process was killed, by the kernel. A lock on the group shows other
processes that the group is in use.
"""

import fcntl
import os
import signal
import sys
from contextlib import suppress

from workbook.inside.memory_cgroup import divide_group, remove_group

TRIES = 5
LONGEST_REMOVAL_S = 30.0
"""The longest time (s) that the removal may take. It's long, because the group's processes may need time to exit."""


def keep(folder: str, prefix: str) -> None:
    """Create a group, print its path, and remove it when standard input is closed.

    Raises OSError if the group can't be created.
    """
    group, lock = make_locked(folder, prefix)
    try:
        divide_group(group)
        print(group, flush=True)
        sys.stdin.read()
    finally:
        remove_group(group, LONGEST_REMOVAL_S)
        os.close(lock)


def make_locked(folder: str, prefix: str) -> tuple[str, int]:
    """Create a group and lock it. Return its path and the descriptor that holds the lock. Raises OSError on failure."""
    for _ in range(TRIES - 1):
        with suppress(BlockingIOError, FileNotFoundError):  # another process removed it before we locked it
            return _make_locked_once(folder, prefix)
    return _make_locked_once(folder, prefix)


def _make_locked_once(folder: str, prefix: str) -> tuple[str, int]:
    group = os.path.join(folder, f"{prefix}{os.urandom(4).hex()}")
    os.mkdir(group)
    lock = os.open(group, os.O_RDONLY | os.O_CLOEXEC)
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        os.stat(group)
    except OSError:
        os.close(lock)
        raise
    return group, lock


def main(arguments: list[str]) -> None:
    """Keep a group for the grading process. Ignore signals from the terminal, which are meant for that process.

    `arguments`: the command-line arguments that the module's docstring describes.
    """
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    try:
        keep(*arguments)
    except OSError as error:
        print(f"!{error.strerror}", flush=True)
