"""Makes a memory cgroup for the groups of one grader, and removes it when the grader ends, however suddenly.

    python -I -S run.py group_keeper FOLDER PREFIX

It writes the path of the new group in FOLDER on its output, or why there is none, and waits until its input is closed:
by the grader, or by the kernel when the grader has been killed. A lock on the group says that somebody keeps it.
"""

import fcntl
import os
import signal
import sys
from contextlib import suppress

from workbook.inside.memory_cgroup import divide_group, remove_group

TRIES = 5
LONGEST_REMOVAL_S = 30.0
"""What still runs in it is being ended by others, too."""


def keep(folder: str, prefix: str) -> None:
    """Make a group, wait, and remove it. Raises OSError when none can be made."""
    group, lock = make_locked(folder, prefix)
    try:
        divide_group(group)
        print(group, flush=True)
        sys.stdin.read()
    finally:
        remove_group(group, LONGEST_REMOVAL_S)
        os.close(lock)


def make_locked(folder: str, prefix: str) -> tuple[str, int]:
    """A new group, and its open file with the lock. Raises OSError."""
    for _ in range(TRIES - 1):
        with suppress(BlockingIOError, FileNotFoundError):  # swept by another grader before it was locked
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
    """Keep a group, with the arguments above. An interrupt is the grader's to obey."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    try:
        keep(*arguments)
    except OSError as error:
        print(f"!{error.strerror}", flush=True)
