"""Whether the process that judges is still able to: what it takes of memory, and whether it gets anywhere."""

import os
import sys
from collections.abc import Sequence

from workbook.inside.proc import (
    command_line,
    process_tree,
    processor_seconds,
    ran_and_waited_s,
    resident_bytes,
    times_main_thread_ran,
)

SLOT_BYTES = 1_000_000_000
"""Memory that a slot may take itself, without the program that it judges. Measured: 130 MB with all that it keeps."""
STUCK_S = 2.5
"""So much processor time (s) the other threads of a slot may use while its main thread does not run even once. It runs
many times a second, whatever it waits for, unless DDS never gives back a lock."""
MOST_SLOWED = 3.0
"""The most that is believed of a busy machine: an answer that keeps all processors busy itself gains no more time."""


class SlotHealth:
    """Watches the process that judges, from outside: `pid`, or one below it whose command line begins with `command`.

    A tier may have put it into a sandbox of its own.
    """

    def __init__(self, pid: int, command: Sequence[str] | None = None) -> None:
        self._pid = pid
        self._begins = b"\0".join(map(os.fsencode, (sys.executable, *(command or ()))))
        self._judge_pid: int | None = None if command is not None else pid
        self._ran: int | None = None
        self._used_then = 0.0
        self._before = (0.0, 0.0)

    def problem(self) -> str | None:
        """Why the slot cannot be relied on any more; None when it can."""
        judge = self._judge()
        if judge is None:
            return None
        if resident_bytes(judge) > SLOT_BYTES:
            return "the slot took too much memory"
        return "the slot made no more progress" if self._is_stuck(judge) else None

    def begin(self) -> None:
        """From now on, `slowed_by` counts."""
        judge = self._judge()
        self._before = (0.0, 0.0) if judge is None else ran_and_waited_s(judge)

    def slowed_by(self) -> float:
        """How many times as long the slot has taken since `begin` because others had the processors: 1 to MOST_SLOWED.

        Counted for its main thread, which has run for some of the time and waited for a processor for some.
        """
        judge = self._judge()
        if judge is None:
            return 1.0
        ran, waited = (now - then for now, then in zip(ran_and_waited_s(judge), self._before, strict=True))
        return min(MOST_SLOWED, 1.0 + waited / ran) if ran > 0 and waited > 0 else 1.0

    def _judge(self) -> int | None:
        if self._judge_pid is None:
            for pid in process_tree(self._pid):
                if self._judge_pid is None and command_line(pid).startswith(self._begins):
                    self._judge_pid = pid
        return self._judge_pid

    def _is_stuck(self, judge: int) -> bool:
        """Whether DDS has been at work all the time since the main thread ran last, and for too long.

        Packets of an answer can keep it there for ever, in a lock that the main thread waits for.
        """
        ran, used = times_main_thread_ran(judge), processor_seconds([judge])
        if ran is None or used is None:
            return False
        if ran != self._ran:
            self._ran, self._used_then = ran, used
        return used - self._used_then > STUCK_S
