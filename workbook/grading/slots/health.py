"""Check whether a slot, which is a process that judges answers, is healthy: its memory use and its progress."""

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
"""The memory limit of a slot without its program, in bytes. We measured 130 MB for a slot with full caches."""
STUCK_S = 2.5
"""The CPU time (s) of a slot's other threads after which the slot counts as stuck if its main thread hasn't run.

The main thread runs many times per second, even while it's waiting, unless DDS never releases a lock.
"""
MOST_SLOWED = 3.0
"""The largest factor by which a busy machine may extend a deadline.

Without this cap, an answer that keeps all processors busy would get more and more time.
"""


class SlotHealth:
    """Watches the judging process of a slot from outside.

    If `command` is None, the judging process is the process `pid`. Otherwise, it's that process or one of its
    descendants, because the isolation tier may have started the judging process in a sandbox. Then it's recognized by
    its command line, which runs Python with `command`.
    """

    def __init__(self, pid: int, command: Sequence[str] | None = None) -> None:
        self._pid = pid
        self._begins = b"\0".join(map(os.fsencode, (sys.executable, *(command or ()))))
        self._judge_pid: int | None = None if command is not None else pid
        self._ran: int | None = None
        self._used_then = 0.0
        self._before = (0.0, 0.0)

    def problem(self) -> str | None:
        """Return why the slot is no longer reliable, or None if it still is."""
        judge = self._judge()
        if judge is None:
            return None
        if resident_bytes(judge) > SLOT_BYTES:
            return "the slot took too much memory"
        return "the slot made no more progress" if self._is_stuck(judge) else None

    def begin(self) -> None:
        """Start measuring for `slowed_by`."""
        judge = self._judge()
        self._before = (0.0, 0.0) if judge is None else ran_and_waited_s(judge)

    def slowed_by(self) -> float:
        """Return the factor by which other processes have slowed the slot down since `begin`.

        The factor is between 1 and MOST_SLOWED. It's computed from the time that the slot's main thread ran and the
        time that it waited for a processor.
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
        """Return whether the other threads, such as DDS's, have used too much CPU time since the main thread last ran.

        Packets from an answer can keep DDS busy forever while it holds a lock that the main thread needs.
        """
        ran, used = times_main_thread_ran(judge), processor_seconds([judge])
        if ran is None or used is None:
            return False
        if ran != self._ran:
            self._ran, self._used_then = ran, used
        return used - self._used_then > STUCK_S
