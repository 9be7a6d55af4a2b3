"""How long the host of a virtual machine takes a processor away from it.

What was to run there is late, although nobody in the machine was busy. Linux counts such time as `steal` and books a
standstill in one piece when it is over; see proc_stat(5). Measured on a machine with two processors: what overslept by
0.07 and 0.14 s found 0.09 and 0.14 s of it.
"""

import os
from collections.abc import Mapping
from pathlib import Path

STAT = Path("/proc/stat")
_STEAL = 8
_TICK_S = 1.0 / os.sysconf("SC_CLK_TCK")


def taken_away(stat: Path = STAT) -> dict[str, float]:
    """Seconds that each processor has been taken away since the machine was started; {} where nobody tells."""
    try:
        lines = [line.split() for line in stat.read_text(encoding="ascii").splitlines()]
        return {
            words[0]: int(words[_STEAL]) * _TICK_S
            for words in lines
            if words and words[0].startswith("cpu") and words[0] != "cpu"
        }
    except (OSError, ValueError, IndexError):
        return {}


class Standstill:
    """Sees standstills from one look to the next. Two looks that are far apart also see what were many short ones."""

    def __init__(self, stat: Path = STAT) -> None:
        self._stat = stat
        self._before: Mapping[str, float] = taken_away(stat)
        self._at_first = self._before

    def look(self) -> float:
        """The longest time (s) for which a processor was taken away since the last look."""
        now = taken_away(self._stat)
        found = [seconds - self._before[name] for name, seconds in now.items() if name in self._before]
        self._before = now
        return max(found, default=0.0)

    def in_all(self) -> float:
        """How long (s) a processor was taken away up to the last look: the mean of all processors."""
        found = [seconds - self._at_first.get(name, seconds) for name, seconds in self._before.items()]
        return sum(found) / len(found) if found else 0.0
