"""Programs that outlive the process which started them: who adopts them, and how they end."""

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
    """Programs do not end, or may not be ended. Says which."""


def adopt_orphans() -> None:
    """Daemons that a program leaves behind become children of this process, so that it can end them."""
    libc.prctl(PR_SET_CHILD_SUBREAPER, 1, 0, 0, 0)


def exempt(pid: int) -> None:
    """No sweep is to end this child of ours, nor what it has started."""
    _exempt.add(pid)


def forget(pid: int) -> None:
    """This child has ended: its number may come again."""
    _exempt.discard(pid)


def forget_all() -> None:
    """In a fork of this process: its children are none of ours."""
    _exempt.clear()


def sweep_orphans() -> int:
    """Kill and reap every process that is left below this one and is not exempt. Returns how many there were.

    Each is stopped as soon as it is seen, and only when no new one is found they are killed: what does not run cannot
    fork away. Raises StillThere after twenty seconds, when new ones still come faster than they can be stopped.
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
    """Stop the descendants of `pid` that are not known yet nor exempt, from the top down. Returns them."""
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
    """Wait for the dead. Their children come to us when they go, so that each of them is ours in the end.

    In any order: the first process of a sandbox cannot be reaped before the others in it are.
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
