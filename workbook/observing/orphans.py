"""Programs that outlive the process which started them: who adopts them, and how they end."""

import ctypes
import os
import signal
from collections.abc import Iterable
from contextlib import suppress

from workbook.observing.tree import children, process_tree

PR_SET_CHILD_SUBREAPER = 36


def adopt_orphans() -> None:
    """Daemons that a program leaves behind become children of this process, so that it can end them."""
    ctypes.CDLL(None).prctl(PR_SET_CHILD_SUBREAPER, 1)


def sweep_orphans(keep: int | None = None) -> int:
    """Kill and reap every process that is left below this one, but for `keep`. Returns how many there were.

    All of them are stopped first, and only then killed: what does not run cannot fork away.
    """
    ended: set[int] = set()
    while below := _below(keep):
        stopped: set[int] = set()
        while newcomers := below - stopped:
            _signal(newcomers, signal.SIGSTOP)
            stopped |= newcomers
            below = _below(keep)
        _signal(stopped, signal.SIGKILL)
        ended |= stopped
        _reap(stopped)
    return len(ended)


def _below(keep: int | None) -> set[int]:
    kept = [] if keep is None else process_tree(keep)
    return set(process_tree(os.getpid())[1:]).difference(kept)


def _signal(pids: Iterable[int], number: signal.Signals) -> None:
    for pid in pids:
        with suppress(ProcessLookupError):
            os.kill(pid, number)


def _reap(killed: set[int]) -> None:
    """Wait for the dead. Their children come to us when they go, so that each of them is ours in the end."""
    while mine := killed.intersection(children(os.getpid())):
        for pid in mine:
            with suppress(ChildProcessError):
                os.waitpid(pid, 0)
