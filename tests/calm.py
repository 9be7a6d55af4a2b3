"""The host of this virtual machine, which may give its processors to others: what is judged meanwhile shows nothing."""

import time
from statistics import fmean

from workbook.inside.proc import stolen_s

TRIES = 3
"""How often a lesson is run that does not show what is committed, while the host takes more than this share:"""
MOST_TAKEN = 0.01
"""Of the processors' time, by other machines on the same host: a standstill of a second is enough to upset a lesson."""
CALM_SHARE = 0.1
LOOK_S = 1.0
LONGEST_S = 60.0


def taken_s() -> float:
    """Seconds for which the host has taken a processor away so far: the mean of all processors."""
    return fmean(stolen_s().values() or [0.0])


def await_calm(longest_s: float = LONGEST_S) -> bool:
    """Wait until the host takes less than a tenth of the processors' time. Returns whether it does."""
    deadline = time.monotonic() + longest_s
    while time.monotonic() < deadline:
        began, before = time.monotonic(), taken_s()
        time.sleep(LOOK_S)
        if taken_s() - before < CALM_SHARE * (time.monotonic() - began):
            return True
    return False
