"""Whether a program has done all that it was woken for, read from the states of its threads."""

import time

from workbook.inside import proc
from workbook.watching.threads import Thread, ThreadTable

LONGEST_WAIT_S = 0.25
BUDGET_S = 4.0
_POLL_S = 0.0005
# Of the time waited so far. To poll more often would only take the core that the program waits for.
_POLL_SHARE = 0.2
LISTED_EVERY_S = 0.1


class Quiescence:
    """Waits until no thread of a program is running or waiting for a core, nor one of ours that receives messages.

    On a busy machine a program waits for a core while simulated time goes on, and misses ticks through no fault
    of its own. A driver of simulated time that waits for quiescence before each step cannot run away from it.

    A program that is never quiet, such as a loop without a pause, is not waited for longer than `LONGEST_WAIT_S` at
    once and `BUDGET_S` in all (s). Where the states cannot be read, everything counts as quiet.
    """

    def __init__(self, pid: int) -> None:
        self._left = BUDGET_S
        self._table = ThreadTable(pid, LISTED_EVERY_S)
        self._suspect: Thread | None = None  # was at work at the last poll, and probably still is

    def wait(self) -> bool:
        """Return as soon as all is quiet, or when patience is at an end. Returns whether it was quiet."""
        if self.is_quiet():
            return True
        began = time.monotonic()
        limit = min(LONGEST_WAIT_S, self._left)
        while (waited := time.monotonic() - began) < limit:
            time.sleep(max(_POLL_S, _POLL_SHARE * waited))
            if self.is_quiet():
                return True
        self._left = max(0.0, self._left - limit)
        return False

    def is_quiet(self) -> bool:
        """Whether all is quiet at this moment."""
        threads = self._table.threads()
        if self._suspect not in threads or not proc.is_at_work(self._suspect.stat):
            self._suspect = next((one for one in threads if proc.is_at_work(one.stat)), None)
        return self._suspect is None

    def close(self) -> None:
        """Close the files that tell of threads."""
        self._suspect = None
        self._table.close()
