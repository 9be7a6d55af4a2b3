"""Who goes first on a busy machine: what is judged on the wall clock. All other tests give way to it.

A nice value belongs to a thread, and what a thread starts inherits it; to take it back needs rights that we may lack.
So one thread begins before its process gives way, and whatever must not wait is started from there.
"""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar

GIVES_WAY = 10
"""Nice value of a worker, and of all that its tests start. Linux gives a process a tenth of what it gives another one
whose value is lower by ten; it still gets all that the other one leaves."""
Result = TypeVar("Result")
_first = ThreadPoolExecutor(1, thread_name_prefix="goes first")


def give_way() -> None:
    """From now on, all that this thread starts gives way to what `at_full_priority` runs."""
    _first.submit(os.getpid).result()  # now the thread is there
    os.nice(GIVES_WAY)


def at_full_priority(work: Callable[[], Result]) -> Result:
    """Run this on the thread that does not give way, and return its result."""
    return _first.submit(work).result()
