"""Find a program's processes by their mark, and end them."""

import os
import signal
import time
from collections.abc import Callable, Collection
from contextlib import suppress

from workbook.inside import proc

RUN_MARK = "WORKBOOK_RUN"
"""The environment variable that identifies a program and its child processes."""
_ROUNDS = 20
_ROUND_S = 0.005


def processes_marked(mark: str) -> list[int]:
    """Return the processes whose `WORKBOOK_RUN` begins with `mark`, if we may read their environments.

    This also finds processes that have moved to another session.
    """
    needle = f"{RUN_MARK}={mark}".encode()
    others = (pid for pid in proc.pids() if pid != os.getpid())
    return [pid for pid in others if any(one.startswith(needle) for one in proc.environment(pid))]


def kill_all(alive: Callable[[], Collection[int]]) -> None:
    """Kill the processes that `alive` returns, until it returns none or after a fixed number of rounds."""
    for _ in range(_ROUNDS):
        left = alive()
        if not left:
            return
        for pid in left:
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        time.sleep(_ROUND_S)


def kill_programs_of(judge_pid: int) -> None:
    """Kill the programs that the ended process `judge_pid` started as a `NodeProcess`, and their descendants."""
    kill_all(lambda: processes_marked(f"{judge_pid}-"))
