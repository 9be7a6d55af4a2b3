"""Gives criteria a budget of time, in whichever thread they are asked for: what takes longer is interrupted.

The work runs in a thread of its own, which an exception interrupts between two steps of Python. A single call that
stays inside C code, such as a search with a regular expression, ends first. In a slot, the deadline of the answer
bounds that as well: the grader kills the slot then, and the answer has an `infra_error`.
"""

import ctypes
import threading
import time
from collections.abc import Callable
from typing import Generic, TypeVar

BUDGET_S = 5.0
"""Processor time (s) that all criteria together have for one recording: a busy machine takes nothing away from it."""
PATIENCE_S = 60.0
"""Real time (s) for the same, so that work that waits instead of computing ends, too."""
GRACE_S = 1.0
"""Real time (s) that interrupted work has to end. What is inside C code for longer is left behind."""
SHORTEST_WAIT_S = 0.01

Made = TypeVar("Made")


class OutOfTime(RuntimeError):
    """Work took more time than its budget."""


class _Interrupted(BaseException):
    """Interrupts work. It is no Exception, so that no `except Exception` of that work catches it."""


class _Worker(threading.Thread, Generic[Made]):
    """A thread for one piece of work. When it is done, it stays until it is released: until then its id is its own."""

    made: Made

    def __init__(self, work: Callable[[], Made]) -> None:
        super().__init__(name="criteria", daemon=True)
        self._work = work
        self._clock: int | None = None
        self._is_called_off = False
        self.error: BaseException | None = None
        self.done, self.released = threading.Event(), threading.Event()

    def run(self) -> None:
        """Do the work and keep what comes of it."""
        try:
            self._clock = time.pthread_getcpuclockid(threading.get_ident())
            if self._is_called_off:
                return
            try:
                self.made = self._work()
            except BaseException as error:
                self.error = error
            self.done.set()
            self.released.wait()
        except _Interrupted:  # it came when the work had just ended
            pass

    def used_s(self) -> float:
        """Processor time (s) that this thread has used so far. Call it before the thread is released."""
        return 0.0 if self._clock is None else time.clock_gettime(self._clock)

    def interrupt(self) -> None:
        """Raise an exception in the thread. Call it once at most, before the thread is released."""
        self._is_called_off = True
        if self.ident is not None:  # otherwise it has not begun, and will not
            raise_in = ctypes.pythonapi.PyThreadState_SetAsyncExc
            raise_in(ctypes.c_ulong(self.ident), ctypes.py_object(_Interrupted))


def within_budget(
    work: Callable[[], Made], budget_s: float = BUDGET_S, patience_s: float = PATIENCE_S
) -> Made:
    """Return what `work` returns, or raise what it raises.

    Raises OutOfTime when it takes more than `budget_s` of processor time, or more than `patience_s` of real time.
    """
    worker = _Worker(work)
    deadline = time.monotonic() + patience_s
    try:
        worker.start()
        while not worker.done.is_set():
            left = min(budget_s - worker.used_s(), deadline - time.monotonic())
            if left <= 0.0:
                break
            worker.done.wait(max(left, SHORTEST_WAIT_S))
    finally:
        in_time = worker.done.is_set()
        if not in_time:
            worker.interrupt()
        worker.released.set()
    worker.join(GRACE_S)
    if not in_time:
        raise OutOfTime(f"the budget of {budget_s:g} s is used up")
    if worker.error is not None:
        raise worker.error
    return worker.made
