"""Notice when the host of this virtual machine gives CPU time to others.

What we judge at such a time proves nothing.
"""

import time
from statistics import fmean

from workbook.inside.proc import stolen_s

TRIES = 3
"""How many times to run a lesson whose outputs differ, if the host took more than this share in each try:"""
MOST_TAKEN = 0.01
"""The share of CPU time that other machines on the host take. A standstill of a second is enough to upset a lesson."""
CALM_SHARE = 0.1
LOOK_S = 1.0
LONGEST_S = 60.0


def taken_s() -> float:
    """Return how many seconds the host has taken from us so far, as the mean over all CPUs."""
    return fmean(stolen_s().values() or [0.0])


def await_calm(longest_s: float = LONGEST_S) -> bool:
    """Wait until the host takes less than a tenth of the CPU time. Return whether it does."""
    deadline = time.monotonic() + longest_s
    while time.monotonic() < deadline:
        began, before = time.monotonic(), taken_s()
        time.sleep(LOOK_S)
        if taken_s() - before < CALM_SHARE * (time.monotonic() - began):
            return True
    return False
