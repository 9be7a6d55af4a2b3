"""Adopt and kill orphans: processes that are still running after the process that started them has exited."""

import os
import signal
import time
from collections.abc import Iterable
from contextlib import suppress

from workbook.inside.libc import libc
from workbook.inside.proc import children

PR_SET_CHILD_SUBREAPER = 36
LONGEST_SWEEP_S = 20.0
REAP_EVERY_S = 0.002

_exempt: set[int] = set()


class StillThere(RuntimeError):
    """Raised when processes are still running after a sweep, or may not be killed. The message says which ones."""


def adopt_orphans() -> None:
    """Make this process adopt the processes that a program leaves behind, so that it can kill them."""
    libc.prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)


def exempt(pid: int) -> None:
    """Exclude our child process `pid` and its descendants from every sweep."""
    _exempt.add(pid)


def forget(pid: int) -> None:
    """Undo `exempt` for a child that has exited, because its process ID may be reused."""
    _exempt.discard(pid)


def forget_all() -> None:
    """Undo `exempt` for all children. Call this function in a forked process, because they aren't its own children."""
    _exempt.clear()


def sweep_orphans() -> int:
    """Kill and reap all our descendants that aren't exempt. Return the number of processes killed.

    Each process is suspended as soon as it's found, because a suspended process can't fork. When no new process is
    found, all of them are killed. Raises StillThere if new processes still appear after 20 s, because they're started
    faster than we can suspend them.
    """
    ended: set[int] = set()
    deadline = time.monotonic() + LONGEST_SWEEP_S
    while True:
        stopped: set[int] = set()
        while time.monotonic() < deadline and (newcomers := _stop_below(os.getpid(), stopped)):
            stopped |= newcomers
        if not stopped:
            return len(ended)
        _signal(stopped, signal.SIGKILL)
        ended |= stopped
        _reap(stopped)
        if time.monotonic() > deadline:
            raise StillThere(
                "programs that this answer has started do not end: they start new ones faster than they can be "
                "stopped. Look for them with `ps` and end them"
            )


def _stop_below(pid: int, known: set[int]) -> set[int]:
    """Suspend the descendants of `pid` that are neither known nor exempt, parents first. Return them."""
    newcomers: set[int] = set()
    waiting, looked_at = [pid], set[int]()
    while waiting:
        for child in children(waiting.pop()):
            if child in _exempt:
                continue
            if child not in known and child not in newcomers:
                _signal([child], signal.SIGSTOP)
                newcomers.add(child)
            if child not in looked_at:
                looked_at.add(child)
                waiting.append(child)
    return newcomers


def _signal(pids: Iterable[int], number: signal.Signals) -> None:
    for pid in pids:
        with suppress(ProcessLookupError):
            os.kill(pid, number)


def _reap(killed: set[int]) -> None:
    """Reap the killed processes as they become our children.

    When a process exits, we adopt its children, so each of the processes becomes our child eventually.

    We don't reap them in a fixed order, because a sandbox's first process can't be reaped before the sandbox's other
    processes.
    """
    while mine := killed.intersection(children(os.getpid())):
        reaped = 0
        for pid in mine:
            try:
                reaped += os.waitpid(pid, os.WNOHANG)[0]
            except ChildProcessError:
                killed.discard(pid)
        if not reaped:
            time.sleep(REAP_EVERY_S)
