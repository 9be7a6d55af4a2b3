"""List a program's threads and our own threads that receive its messages, and keep the files with their states open."""

import os
import time
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass

from workbook.inside import proc

OWN_THREADS = b"dds."
"""The prefix of the names that Fast DDS gives to threads that receive messages."""


@dataclass(frozen=True, eq=False)
class Thread:
    """The descriptors of a thread's files in /proc.

    `schedstat` is None if the kernel doesn't provide this file. `syscall` is None for our own threads, or if the kernel
    doesn't let us read the file.
    """

    stat: int
    schedstat: int | None
    syscall: int | None

    def close(self) -> None:
        """Close the files."""
        for fd in (self.stat, self.schedstat, self.syscall):
            if fd is not None:
                os.close(fd)


class ThreadTable:
    """Lists the threads of a program, whose first process is `pid`, and our threads that receive messages.

    `threads` updates the list if it's older than `listed_every_s` (s), or if that process's number of threads has
    changed.
    """

    def __init__(self, pid: int, listed_every_s: float) -> None:
        self._pid = pid
        self._every_s = listed_every_s
        self._listed_at = -listed_every_s
        self._how_many = 0
        self._threads: dict[str, Thread] = {}
        self._receivers: set[str] = set()
        self._others: set[str] = set()

    def threads(self) -> list[Thread]:
        """Return all threads. Update the list first if necessary."""
        how_many = proc.how_many_threads(self._pid)
        if how_many != self._how_many or time.monotonic() - self._listed_at >= self._every_s:
            self._how_many = how_many
            self.update()
        return [*self._threads.values()]

    def close(self) -> None:
        """Close all files."""
        while self._threads:
            self._threads.popitem()[1].close()

    def update(self) -> None:
        """List the threads again."""
        self._listed_at = time.monotonic()
        wanted = dict(self._folders())
        for folder in self._threads.keys() - wanted.keys():
            self._threads.pop(folder).close()
        for folder in wanted.keys() - self._threads.keys():
            with suppress(OSError):  # the thread has finished in the meantime
                self._threads[folder] = _open(folder, of_program=wanted[folder])

    def _folders(self) -> Iterator[tuple[str, bool]]:
        """Yield each thread's folder in /proc, and whether the thread belongs to the program."""
        there = set(proc.tasks(os.getpid()))
        self._receivers &= there
        self._others &= there
        for task in there - self._receivers - self._others:
            with suppress(OSError):
                receives = proc.thread_name(task).startswith(OWN_THREADS)
                (self._receivers if receives else self._others).add(task)
        yield from ((proc.thread_folder("self", task), False) for task in self._receivers)
        for pid in proc.process_tree(self._pid):
            yield from ((proc.thread_folder(pid, task), True) for task in proc.tasks(pid))


def _open(folder: str, *, of_program: bool) -> Thread:
    """Open a thread's files. Raise OSError if the thread has finished."""
    stat = os.open(f"{folder}/stat", os.O_RDONLY | os.O_CLOEXEC)
    return Thread(
        stat, _open_if(f"{folder}/schedstat"), _open_if(f"{folder}/syscall") if of_program else None
    )


def _open_if(path: str) -> int | None:
    """Open a file. Return None if the kernel doesn't provide it or doesn't let us read it."""
    try:
        return os.open(path, os.O_RDONLY | os.O_CLOEXEC)
    except OSError:
        return None
