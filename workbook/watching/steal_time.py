"""How long the host of a virtual machine takes a processor away from it: steal time.

What was to run there is late, although nobody in the machine was busy. Linux books a standstill in one piece when it is
over; see proc_stat(5). Measured on a machine with two processors: what overslept by 0.07 and 0.14 s found 0.09 and
0.14 s of it.
"""

from collections.abc import Mapping
from os import PathLike

from workbook.inside.proc import PROC_STAT, stolen_s


class StealTime:
    """Steal time from one poll to the next. Two polls that are far apart also see what were many short ones."""

    def __init__(self, stat: str | PathLike[str] = PROC_STAT) -> None:
        self._stat = stat
        self._before: Mapping[str, float] = stolen_s(stat)
        self._at_first = self._before

    def longest_since_last(self) -> float:
        """The longest time (s) for which a processor was taken away since the last poll."""
        now = stolen_s(self._stat)
        found = [seconds - self._before[name] for name, seconds in now.items() if name in self._before]
        self._before = now
        return max(found, default=0.0)

    def in_all(self) -> float:
        """How long (s) a processor was taken away up to the last poll: the mean of all processors."""
        found = [seconds - self._at_first.get(name, seconds) for name, seconds in self._before.items()]
        return sum(found) / len(found) if found else 0.0
