"""Detect, from the states of a program's threads, whether the program has finished its current work."""

import time

from workbook.inside import proc
from workbook.watching.threads import Thread, ThreadTable

LONGEST_WAIT_S = 0.25
BUDGET_S = 4.0
_POLL_S = 0.0005
# A fraction of the time waited so far. More frequent polls would take the core away from the program.
_POLL_SHARE = 0.2
LISTED_EVERY_S = 0.1


class Quiescence:
    """Waits until no thread of a program, and none of ours that receive messages, is running or waiting for a core.

    On a busy machine, a program may have to wait for a core. If simulated time went on in the meantime, the program
    would miss clock ticks without being at fault. So the code that advances simulated time waits for quiescence before
    each step.

    Some programs are never quiet, for example because of a loop without a pause. We wait for such a program at most
    `LONGEST_WAIT_S` per call and `BUDGET_S` in total (both in s). If the states can't be read, all threads count as
    quiet.
    """

    def __init__(self, pid: int) -> None:
        self._left = BUDGET_S
        self._table = ThreadTable(pid, LISTED_EVERY_S)
        self._suspect: Thread | None = None  # was at work at the last poll, and probably still is

    def wait(self) -> bool:
        """Wait until all threads are quiet, or until the time is up. Return whether they became quiet."""
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
        """Return whether all threads are quiet at this moment."""
        threads = self._table.threads()
        if self._suspect not in threads or not proc.is_at_work(self._suspect.stat):
            self._suspect = next((one for one in threads if proc.is_at_work(one.stat)), None)
        return self._suspect is None

    def close(self) -> None:
        """Close the files that report the threads' states."""
        self._suspect = None
        self._table.close()
