"""Whether a program has come to rest, so that the next step of the clock loses nothing.

At rest means: there was a moment at which no thread of the program, and no thread of ours that receives its messages,
was running or waiting for a processor. All threads were asleep at one moment if each was seen asleep, and none was
given a processor from before the first look until after the last. Linux counts that for each thread (`schedstat`, see
https://docs.kernel.org/scheduler/sched-stats.html).

A thread that sleeps for a time of its own is not at rest: it goes on by itself, in real time (see `sleeps`).
"""

import enum
import math
import time

from workbook.inside import proc
from workbook.watching.sleeps import CALLS, goes_on_by_itself
from workbook.watching.threads import Thread, ThreadTable

LISTED_EVERY_S = 0.05
"""A thread that a child process has just begun is not seen for so long (s); what has started it is."""
LONGEST_WAIT_S = 0.25
"""A callback that computes or sleeps for so long (s) is waited for."""
WORK_WAITS, SLEEP_WAITS = 4, 2
"""How often a wait may end in vain until a program counts as one that does not come to rest."""
POLL_S = 0.0001
POLL_SHARE = 0.1
"""Of the time waited so far. To poll more often would only take the processor that the program waits for."""
FIRST_LOOK_SHARE = 0.5
LONGEST_UNLOOKED_S = 0.001
"""Nobody looks until half of the time has passed that the program needed for the step before, at most so long (s)."""


class State(enum.Enum):
    """What a program was last seen doing."""

    AT_REST = "at rest"
    SLEEPING = "a thread sleeps for a while"
    AT_WORK = "at work"


class LockStep:
    """Waits until the program whose first process is `pid` is at rest, as long as it comes to rest at all.

    `works` tells whether that is so: not where the kernel does not tell of threads, nor for a program that is always at
    work (a MultiThreadedExecutor that waits for a free thread, a loop without a pause) or that lives by its own sleep.
    `never_in_vain`: whether each wait up to now ended with the program at rest. `slept_s`: for how long (s) in
    all, and `longest_nap_s` at most, a wait saw a thread asleep before the program came to rest.
    """

    def __init__(self, pid: int) -> None:
        self._table = ThreadTable(pid, LISTED_EVERY_S)
        self._suspect: Thread | None = None  # the last one that was seen at work, and probably the next one
        self._took_s = 0.0
        self._naps: dict[int, tuple[bytes, bool]] = {}
        self._vain = {State.SLEEPING: SLEEP_WAITS, State.AT_WORK: WORK_WAITS}
        self.never_in_vain = True
        self.slept_s = self.longest_nap_s = 0.0
        self._can_tell = bool(CALLS) and self._is_told()

    @property
    def works(self) -> bool:
        """Whether it is worth while to wait for rest."""
        return self._can_tell and min(self._vain.values()) > 0

    def wait(self) -> State:
        """Return as soon as the program is at rest, or when patience is at an end. Returns what it was doing then."""
        began = time.monotonic()
        asleep_since = math.inf
        time.sleep(FIRST_LOOK_SHARE * self._took_s)
        while (state := self.state()) is not State.AT_REST:
            waited = time.monotonic() - began
            if state is State.SLEEPING:
                asleep_since = min(asleep_since, waited)
            if waited >= LONGEST_WAIT_S:
                self._vain[state] -= 1
                self.never_in_vain = False
                break
            time.sleep(max(POLL_S, POLL_SHARE * waited))
        else:
            nap_s = max(0.0, time.monotonic() - began - asleep_since)
            self.slept_s += nap_s
            self.longest_nap_s = max(self.longest_nap_s, nap_s)
        self._took_s = min(time.monotonic() - began, LONGEST_UNLOOKED_S)
        return state

    def state(self) -> State:
        """What the program is doing at this moment.

        To look at all threads takes a while, and on a busy machine that is time which the program waits for.
        """
        threads = self._table.threads()
        if self._suspect in threads and proc.is_at_work(self._suspect.stat):
            return State.AT_WORK
        before = [_times_scheduled(thread) for thread in threads]
        for thread in threads:
            if proc.is_at_work(thread.stat):
                self._suspect = thread
                return State.AT_WORK
        sleeping = any(self._goes_on_by_itself(*one) for one in zip(threads, before, strict=True))
        if before != [_times_scheduled(thread) for thread in threads]:
            return State.AT_WORK
        return State.SLEEPING if sleeping else State.AT_REST

    def _goes_on_by_itself(self, thread: Thread, scheduled: bytes) -> bool:
        """Whether a thread that is asleep, and was `scheduled` so often before, goes on without being told to.

        The kernel is asked once: as long as the thread is not scheduled again, it is in the same call.
        """
        if thread.syscall is None:
            return False
        asked, answer = self._naps.get(thread.syscall, (b"", False))
        if asked != scheduled:
            answer = goes_on_by_itself(proc.system_call(thread.syscall))
            self._naps[thread.syscall] = scheduled, answer
        return answer

    def close(self) -> None:
        """Close the files that tell of threads."""
        self._suspect = None
        self._naps.clear()
        self._table.close()

    def _is_told(self) -> bool:
        """Whether the kernel tells how often threads are scheduled, and which call those of the program are in."""
        threads = self._table.threads()
        calls = [thread.syscall for thread in threads if thread.syscall is not None]
        counted = all(len(_times_scheduled(thread).split()) == 3 for thread in threads)
        return counted and bool(calls) and all(map(proc.system_call, calls))


def _times_scheduled(thread: Thread) -> bytes:
    return b"" if thread.schedstat is None else proc.times_scheduled(thread.schedstat)
