"""Finding the processes that a program has started by their mark, and ending them."""

import os
import signal
import time
from collections.abc import Callable, Collection
from contextlib import suppress

from workbook.inside import proc

RUN_MARK = "WORKBOOK_RUN"
"""The variable by which a program and what came of it are found among all processes."""
_ROUNDS = 20
_ROUND_S = 0.005


def processes_marked(mark: str) -> list[int]:
    """Processes (of this user) whose `WORKBOOK_RUN` begins with `mark`, whatever session they moved to."""
    needle = f"{RUN_MARK}={mark}".encode()
    others = (pid for pid in proc.pids() if pid != os.getpid())
    return [pid for pid in others if any(one.startswith(needle) for one in proc.environment(pid))]


def kill_all(alive: Callable[[], Collection[int]]) -> None:
    """Kill the processes that `alive` returns until it returns none, or a fixed number of rounds is over."""
    for _ in range(_ROUNDS):
        left = alive()
        if not left:
            return
        for pid in left:
            with suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)
        time.sleep(_ROUND_S)


def kill_programs_of(judge_pid: int) -> None:
    """Kill what the dead process `judge_pid` had started as a `NodeProcess`, and all that came of it."""
    kill_all(lambda: processes_marked(f"{judge_pid}-"))
