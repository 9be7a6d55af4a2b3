"""Measure *steal time*: the time for which a virtual machine's host takes a processor away from the machine.

Threads on that processor are late, although the virtual machine itself isn't busy. Linux counts a standstill only once
it's over; see proc_stat(5). On a machine with two processors, threads that overslept by 0.07 and 0.14 s measured 0.09
and 0.14 s of steal time.
"""

from collections.abc import Mapping
from os import PathLike

from workbook.inside.proc import PROC_STAT, stolen_s


class StealTime:
    """Measures steal time between polls.

    If two polls are far apart, many short standstills may look like a long one.
    """

    def __init__(self, stat: str | PathLike[str] = PROC_STAT) -> None:
        self._stat = stat
        self._before: Mapping[str, float] = stolen_s(stat)
        self._at_first = self._before

    def longest_since_last(self) -> float:
        """Return the steal time, in seconds, since the last poll, for the processor with the most."""
        now = stolen_s(self._stat)
        found = [seconds - self._before[name] for name, seconds in now.items() if name in self._before]
        self._before = now
        return max(found, default=0.0)

    def in_all(self) -> float:
        """Return the total steal time, in seconds, up to the last poll, averaged over the processors."""
        found = [seconds - self._at_first.get(name, seconds) for name, seconds in self._before.items()]
        return sum(found) / len(found) if found else 0.0
