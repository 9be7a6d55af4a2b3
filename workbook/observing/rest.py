"""Whether a program has done all that it was woken for, read from the states of its threads."""

import os
import time
from contextlib import suppress

from workbook.observing.tree import process_tree, read_proc

LONGEST_WAIT_S = 0.25
BUDGET_S = 4.0
OWN_THREADS = b"dds."
_POLL_S = 0.0005
# Of the time waited so far. To look more often would only take the core that the program waits for.
_POLL_SHARE = 0.2
_LIST_EVERY_S = 0.1


class Rest:
    """Waits until no thread of a program is running or waiting for a core, nor one of ours that receives messages.

    On a busy machine a program stands in line for a core while robot time goes on, and misses ticks through no fault
    of its own. A driver of robot time that waits for rest before each step cannot run away from it.

    A program that never rests, such as a loop without a pause, is not waited for longer than `LONGEST_WAIT_S` at
    once and `BUDGET_S` in all (s). Where the states cannot be read, everything counts as at rest.
    """

    def __init__(self, pid: int) -> None:
        self._pid = pid
        self._left = BUDGET_S
        self._listed = -_LIST_EVERY_S
        self._states: dict[str, int] = {}
        self._own: set[str] = set()
        self._suspect: int | None = None  # was at work when we last looked, and probably still is

    def wait(self) -> bool:
        """Return as soon as all is at rest, or when patience is at an end. Returns whether it was at rest."""
        if self.now():
            return True
        began = time.monotonic()
        limit = min(LONGEST_WAIT_S, self._left)
        while (waited := time.monotonic() - began) < limit:
            time.sleep(max(_POLL_S, _POLL_SHARE * waited))
            if self.now():
                return True
        self._left = max(0.0, self._left - limit)
        return False

    def now(self) -> bool:
        """Whether all is at rest at this moment."""
        if time.monotonic() - self._listed >= _LIST_EVERY_S:
            self._list()
        if self._suspect is None or not _is_at_work(self._suspect):
            self._suspect = next(filter(_is_at_work, self._states.values()), None)
        return self._suspect is None

    def close(self) -> None:
        self._suspect = None
        while self._states:
            os.close(self._states.popitem()[1])

    def _list(self) -> None:
        self._listed = time.monotonic()
        self._suspect = None
        self._own = _own_tasks(self._own)
        wanted = {f"/proc/self/task/{task}/stat" for task in self._own}
        for pid in process_tree(self._pid):
            wanted |= {f"/proc/{pid}/task/{task}/stat" for task in _tasks(pid)}
        for path in self._states.keys() - wanted:
            os.close(self._states.pop(path))
        for path in wanted - self._states.keys():
            with suppress(OSError):
                self._states[path] = os.open(path, os.O_RDONLY | os.O_CLOEXEC)


def _tasks(pid: int) -> list[str]:
    try:
        return os.listdir(f"/proc/{pid}/task")
    except OSError:
        return []


def _own_tasks(known: set[str]) -> set[str]:
    """Our threads that receive messages; DDS names them. `known` are those of the last time."""
    there = _tasks(os.getpid())
    found = known.intersection(there)
    for task in there:
        if task not in found:
            with suppress(OSError):
                if read_proc(f"/proc/self/task/{task}/comm").startswith(OWN_THREADS):
                    found.add(task)
    return found


def _is_at_work(state: int) -> bool:
    try:
        line = os.pread(state, 512, 0)
    except OSError:  # the thread has ended
        return False
    after_name = line.rfind(b")") + 2
    return line[after_name : after_name + 1] in (b"R", b"D")
