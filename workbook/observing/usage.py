"""What a program takes from the machine, as far as the limits of its single processes cannot hold it back."""

import os
import re
from collections.abc import Sequence
from pathlib import Path

from workbook.observing.sandbox import HOME, WRITABLE_BYTES
from workbook.observing.tree import read_proc

WRITABLE = ("/tmp", "/dev/shm", HOME)
_PAGE = os.sysconf("SC_PAGE_SIZE")
_LAST_LINES = 3
_TOLD = {
    "memory": r"MemoryError|std::bad_alloc|Cannot allocate memory",
    "open_files": r"Too many open files",
    "file_size": r"File too large",
    "disk": r"No space left on device",
    "processes": r"can't start new thread|Resource temporarily unavailable",
}


def memory_of(pids: Sequence[int], worth_counting: int) -> int:
    """Bytes of memory that these processes hold together.

    What they share after a fork is counted once, which takes a while, and only from `worth_counting` bytes on.
    """
    rough = sum(map(_resident, pids))
    return rough if rough <= worth_counting else sum(map(_share, pids))


def _resident(pid: int) -> int:
    try:
        return int(read_proc(f"/proc/{pid}/statm").split()[1]) * _PAGE
    except (OSError, IndexError):
        return 0


def _share(pid: int) -> int:
    """Memory of a process, of what it shares with others its part."""
    try:
        text = Path(f"/proc/{pid}/smaps_rollup").read_text()
    except OSError:
        return 0
    found = re.search(r"^Pss:\s+(\d+) kB$", text, re.MULTILINE)
    return int(found[1]) * 1024 if found else 0


def most_files(pids: Sequence[int]) -> int:
    """How many files and folders the fullest folder holds that a program in a box may write to.

    A process that is not in its box yet sees the folders of the machine, which have more room: they do not count.
    """
    most = 0
    for pid in pids:
        try:
            spaces = [os.statvfs(f"/proc/{pid}/root{folder}") for folder in WRITABLE]
        except OSError:
            continue
        if all(space.f_blocks * space.f_frsize <= WRITABLE_BYTES for space in spaces):
            most = max(most, *(space.f_files - space.f_ffree for space in spaces))
    return most


def limits_told(log: str) -> tuple[str, ...]:
    """Limits that the last lines of a program's log tell of, in the words of Python and of C.

    Whoever prints such a line and ends is believed: it earns nothing.
    """
    end = "\n".join([line for line in log.splitlines() if line.strip()][-_LAST_LINES:])
    return tuple(name for name, pattern in _TOLD.items() if re.search(pattern, end))
