"""Run criteria with a time budget, in any thread, and interrupt work that exceeds the budget.

The work runs in a separate thread, which we interrupt by raising an exception between two of its Python instructions. A
call that stays inside C code, such as a regular expression search, has to return first. In a grading slot, even such a
call can't outlast the answer's deadline, because the slot is killed and the answer gets an `infra_error`.
"""

import ctypes
import threading
import time
from collections.abc import Callable
from typing import Generic, TypeVar

BUDGET_S = 5.0
"""The CPU time (s) that all criteria together may use for one recording. Waiting on a busy machine doesn't count."""
PATIENCE_S = 60.0
"""The wall-clock time (s) for the same work. This limit also stops work that waits instead of computing."""
GRACE_S = 1.0
"""The wall-clock time (s) for interrupted work to finish. Work that stays inside C code for longer is abandoned."""
SHORTEST_WAIT_S = 0.01

Made = TypeVar("Made")


class OutOfTime(RuntimeError):
    """Raised when work exceeds its budget."""


class _Interrupted(BaseException):
    """Raised in a thread to interrupt its work. It isn't an Exception, so `except Exception` doesn't catch it."""


class _Worker(threading.Thread, Generic[Made]):
    """A thread that runs one function, and then stays alive until it's released, so that its ID isn't reused."""

    made: Made

    def __init__(self, work: Callable[[], Made]) -> None:
        super().__init__(name="criteria", daemon=True)
        self._work = work
        self._clock: int | None = None
        self._is_called_off = False
        self.error: BaseException | None = None
        self.done, self.released = threading.Event(), threading.Event()

    def run(self) -> None:
        """Run the function, and store its result or its exception."""
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
        except _Interrupted:  # the interrupt arrived just after the work had finished
            pass

    def used_s(self) -> float:
        """Return the CPU time (s) that this thread has used. Call this before the thread is released."""
        return 0.0 if self._clock is None else time.clock_gettime(self._clock)

    def interrupt(self) -> None:
        """Raise `_Interrupted` in the thread. Call this at most once, and before the thread is released."""
        self._is_called_off = True
        if self.ident is not None:  # otherwise, the thread hasn't started, and won't do any work
            raise_in = ctypes.pythonapi.PyThreadState_SetAsyncExc
            raise_in(ctypes.c_ulong(self.ident), ctypes.py_object(_Interrupted))


def within_budget(
    work: Callable[[], Made], budget_s: float = BUDGET_S, patience_s: float = PATIENCE_S
) -> Made:
    """Run `work`, and return its result or raise its exception.

    Raises OutOfTime if the work takes more than `budget_s` seconds of CPU time or `patience_s` seconds of wall-clock
    time.
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
