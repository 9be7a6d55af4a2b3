"""Compare a program's use of the machine with the limits that the kernel can't enforce per process."""

import re
from collections.abc import Iterable, Sequence
from contextlib import suppress

from workbook.inside.descriptors import descriptors, descriptors_watched
from workbook.inside.proc import how_many_threads, memory_bytes, stat_fields
from workbook.programs.tier import Confinement
from workbook.recording.limits import ENDED_PROCESSES, Limits

WATCHFUL_S = 0.05
AT_EASE_S = 0.2
_LAST_LINES = 3
_SAID = {
    "memory": r"MemoryError|std::bad_alloc|Cannot allocate memory",
    "open_files": r"Too many open files",
    "file_size": r"File too large",
    "disk": r"No space left on device",
    "processes": r"can't start new thread|Resource temporarily unavailable",
}


def limit_exceeded(limits: Limits, pids: Sequence[int], confinement: Confinement) -> str | None:
    """Return the name of a limit that a program's processes `pids` exceed together, or None if they exceed none."""
    hit = confinement.exceeded()
    if hit is not None:
        return hit
    if limits.processes is not None and too_many(pids, limits.processes):
        return "processes"
    if limits.threads is not None and sum(map(how_many_threads, pids)) > limits.threads:
        return "processes"
    if limits.descriptors is not None and limits.watches is not None:
        links = descriptors(pids)
        if len(links) > limits.descriptors or descriptors_watched(links, limits.watches) > limits.watches:
            return "descriptors"
    if limits.memory is not None and memory_bytes(pids, limits.memory) > limits.memory:
        return "memory"
    if limits.files is not None and confinement.most_files(pids) > limits.files:
        return "files"
    if limits.stored is not None and confinement.stored_bytes(pids) > limits.stored:
        return "disk"
    if limits.sockets is not None and confinement.sockets(pids) > limits.sockets:
        return "sockets"
    if limits.queued is not None and confinement.queued_bytes(limits.queued) > limits.queued:
        return "sockets"
    return None


def too_many(pids: Sequence[int], most: int) -> bool:
    """Return whether more than `most` of these processes are running, or far more exist if zombies are counted, too."""
    return len(pids) > most and (len(pids) > most + ENDED_PROCESSES or len(running(pids)) > most)


def running(pids: Iterable[int]) -> list[int]:
    """Return the processes that are still running. Zombies, which still have a process ID, are left out."""
    found = []
    for pid in pids:
        with suppress(OSError):
            if stat_fields(pid)[0] not in (b"Z", b"X"):
                found.append(pid)
    return found


def until_next_look_s(limits: Limits, pids: Sequence[int]) -> float:
    """Return the time, in seconds, to wait until the next poll.

    Frequent polling takes as much CPU time as a small node, so we poll less often while a program is far from its
    limits. It can't reach the memory limit during the longer wait, because a processor fills only about 2 GB per
    second.
    """
    processes, memory = limits.processes or 0, limits.memory or 0
    is_far = 2 * len(pids) <= processes and 2 * memory_bytes(pids, memory) <= memory
    return AT_EASE_S if is_far else WATCHFUL_S


def limits_in_log(log: str) -> tuple[str, ...]:
    """Return the limits that a program hit, judging by Python's and C's error messages in the last lines of its log.

    A program could print such a message itself, but it wouldn't gain anything from it.
    """
    end = "\n".join([line for line in log.splitlines() if line.strip()][-_LAST_LINES:])
    return tuple(name for name, pattern in _SAID.items() if re.search(pattern, end))
