"""The descriptors of processes, as /proc shows them: how many there are, and what epoll instances watch."""

import os
from collections.abc import Iterable
from contextlib import suppress

from workbook.inside.proc import read

EPOLL = "anon_inode:[eventpoll]"


def descriptors(pids: Iterable[int]) -> list[str]:
    """The descriptors that these processes have open, as links; what they share counts in each of them."""
    found: list[str] = []
    for pid in pids:
        folder = f"/proc/{pid}/fd/"
        with suppress(OSError):
            found += [folder + number for number in os.listdir(folder)]
    return found


def descriptors_watched(links: Iterable[str], enough: int) -> int:
    """How many descriptors the epoll instances among `links` watch. Counting ends where it is more than `enough`."""
    watched = 0
    for link in links:
        with suppress(OSError):
            if os.readlink(link) == EPOLL:
                watched += read(link.replace("/fd/", "/fdinfo/")).count(b"tfd:")
        if watched > enough:
            break
    return watched
