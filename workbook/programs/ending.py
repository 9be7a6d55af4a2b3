"""Find a program's processes and kill them.

A program's mark is the value of its environment variable `WORKBOOK_RUN`, which its child processes inherit. It begins
with the process ID of the judge that started the program.
"""

import os
import signal
import time
from collections.abc import Callable, Collection
from contextlib import suppress

from workbook.inside import proc

RUN_MARK = "WORKBOOK_RUN"
"""The environment variable whose value, the mark, identifies a program and its descendants."""
_ROUNDS = 20
_ROUND_S = 0.005


def processes_marked(mark: str) -> list[int]:
    """Return the processes whose mark begins with `mark`, except those whose environment we may not read.

    The result includes processes that have moved to another session.
    """
    needle = f"{RUN_MARK}={mark}".encode()
    others = (pid for pid in proc.pids() if pid != os.getpid())
    return [pid for pid in others if any(one.startswith(needle) for one in proc.environment(pid))]


def kill_all(alive: Callable[[], Collection[int]]) -> None:
    """Kill the processes that `alive` returns.

    Repeat that until `alive` returns none, but only a fixed number of times.
    """
    for _ in range(_ROUNDS):
        left = alive()
        if not left:
            return
        for pid in left:
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        time.sleep(_ROUND_S)


def kill_programs_of(judge_pid: int) -> None:
    """Kill the programs that the judge with process ID `judge_pid` started before it exited, and their descendants."""
    kill_all(lambda: processes_marked(f"{judge_pid}-"))
