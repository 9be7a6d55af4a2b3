"""List processes' open descriptors, and count the descriptors that their epoll instances watch, using /proc."""

import os
from collections.abc import Iterable
from contextlib import suppress

from workbook.inside.proc import read

EPOLL = "anon_inode:[eventpoll]"


def descriptors(pids: Iterable[int]) -> list[str]:
    """Return these processes' open descriptors, as paths in /proc.

    A descriptor that processes share is listed for each of them.
    """
    found: list[str] = []
    for pid in pids:
        folder = f"/proc/{pid}/fd/"
        with suppress(OSError):
            found += [folder + number for number in os.listdir(folder)]
    return found


def descriptors_watched(links: Iterable[str], enough: int) -> int:
    """Count the descriptors that the epoll instances among `links` watch.

    Stop as soon as the count exceeds `enough`.
    """
    watched = 0
    for link in links:
        with suppress(OSError):
            if os.readlink(link) == EPOLL:
                watched += read(link.replace("/fd/", "/fdinfo/")).count(b"tfd:")
        if watched > enough:
            break
    return watched
