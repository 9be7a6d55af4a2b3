"""Detect when a program is quiet or at rest, so that the next clock step doesn't overtake it.

A program is *quiet* if, at the moment of one poll, none of its threads is running or waiting for a processor. Our
threads that receive the program's messages must be quiet, too. On a busy machine, a program may have to wait for a
processor. If simulated time went on in the meantime, the program would miss clock steps without being at fault.

A program is *at rest* if it does nothing more until the next clock step. Two conditions prove that: we saw each thread
asleep, and no thread was scheduled between the first poll and the last. Linux counts how often each thread was
scheduled (`schedstat`, see https://docs.kernel.org/scheduler/sched-stats.html). A thread that sleeps for a fixed time
isn't at rest, because it continues by itself in real time (see `sleeps`). In *lockstep*, the clock takes a step only
after the program has come to rest.
"""

import enum
import math
import time
from functools import cached_property

from workbook.inside import proc
from workbook.watching.sleeps import CALLS, goes_on_by_itself
from workbook.watching.threads import Thread, ThreadTable

LISTED_EVERY_S = 0.05
"""How long (s) a child process's new thread may be missing from our list.

That's harmless, because the thread that started it is already listed.
"""
LONGEST_WAIT_S = 0.25
"""The longest wait (s) for a callback that computes or sleeps."""
WORK_WAITS, SLEEP_WAITS = 4, 2
"""The numbers of waits in vain, for a thread at work or asleep, after which we assume that the program never rests."""
BUDGET_S = 4.0
"""The longest total of waits in vain (s) for a program to become quiet."""
POLL_S = 0.0001
POLL_SHARE = 0.1
"""The pause between two polls, as a fraction of the time waited so far. More polls would slow the program down."""
QUIET_POLL_S = 0.0005
QUIET_POLL_SHARE = 0.2
"""The same for `wait_until_quiet`, whose callers can wait longer."""
FIRST_LOOK_SHARE = 0.5
LONGEST_UNLOOKED_S = 0.001
"""Before the first poll, `wait_for_rest` sleeps for this share of its previous duration, at most of this time (s)."""


class State(enum.Enum):
    """The state of a program at the last poll."""

    AT_REST = "at rest"
    SLEEPING = "a thread sleeps for a while"
    AT_WORK = "at work"


class RestDetector:
    """Waits until a program, whose first process is `pid`, is quiet or at rest.

    `never_in_vain`: whether the program was at rest after each `wait_for_rest` so far. `slept_s` and `longest_nap_s`:
    the total and the longest time (s) that we waited for a sleeping thread before the program came to rest. If the
    threads' states can't be read, all threads count as quiet.
    """

    def __init__(self, pid: int) -> None:
        self._table = ThreadTable(pid, LISTED_EVERY_S)
        self._suspect: Thread | None = None  # the last thread seen at work, which is probably at work again
        self._left_s = BUDGET_S
        self._took_s = 0.0
        self._naps: dict[int, tuple[bytes, bool]] = {}
        self._vain = {State.SLEEPING: SLEEP_WAITS, State.AT_WORK: WORK_WAITS}
        self.never_in_vain = True
        self.slept_s = self.longest_nap_s = 0.0

    @property
    def works(self) -> bool:
        """Whether waiting for the program to rest is useful.

        It's useless if the kernel doesn't report threads, if the program paces itself by sleeping, or if a thread is
        always at work. Examples of such work are a MultiThreadedExecutor that waits for a free thread, and a loop
        without a pause.
        """
        return self._can_tell and min(self._vain.values()) > 0

    def is_quiet(self) -> bool:
        """Return whether no thread is at work at this moment."""
        threads = self._table.threads()
        return not self._is_suspect_at_work(threads) and not self._is_any_at_work(threads)

    def wait_until_quiet(self) -> bool:
        """Wait until the program is quiet, for at most `LONGEST_WAIT_S`. Waits in vain may total `BUDGET_S`.

        Return whether the program became quiet. Some programs never do, for example because of a loop without a pause.
        """
        began = time.monotonic()
        limit = min(LONGEST_WAIT_S, self._left_s)
        while not self.is_quiet():
            waited = time.monotonic() - began
            if waited >= limit:
                self._left_s -= limit
                return False
            time.sleep(max(QUIET_POLL_S, QUIET_POLL_SHARE * waited))
        return True

    def wait_for_rest(self) -> State:
        """Wait until the program is at rest, at most `LONGEST_WAIT_S`. Return its last state."""
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
        """Return the program's current state."""
        threads = self._table.threads()
        if self._is_suspect_at_work(threads):
            return State.AT_WORK
        before = [_times_scheduled(thread) for thread in threads]
        if self._is_any_at_work(threads):
            return State.AT_WORK
        sleeping = any(self._goes_on_by_itself(*one) for one in zip(threads, before, strict=True))
        if before != [_times_scheduled(thread) for thread in threads]:
            return State.AT_WORK
        return State.SLEEPING if sleeping else State.AT_REST

    def _is_suspect_at_work(self, threads: list[Thread]) -> bool:
        """Return whether the thread that was last seen at work is at work now.

        Poll it first: polling all threads takes CPU time that the program lacks on a busy machine.
        """
        return self._suspect in threads and proc.is_at_work(self._suspect.stat)

    def _is_any_at_work(self, threads: list[Thread]) -> bool:
        for thread in threads:
            if proc.is_at_work(thread.stat):
                self._suspect = thread
                return True
        return False

    def _goes_on_by_itself(self, thread: Thread, scheduled: bytes) -> bool:
        """Return whether a sleeping thread with the scheduling counters `scheduled` continues by itself.

        The result is cached, because a thread stays in the same system call until it's scheduled again.
        """
        if thread.syscall is None:
            return False
        asked, answer = self._naps.get(thread.syscall, (b"", False))
        if asked != scheduled:
            answer = goes_on_by_itself(proc.system_call(thread.syscall))
            self._naps[thread.syscall] = scheduled, answer
        return answer

    def close(self) -> None:
        """Close the files that report the threads' states."""
        self._suspect = None
        self._naps.clear()
        self._table.close()

    @cached_property
    def _can_tell(self) -> bool:
        """Whether the kernel reports how often threads are scheduled, and which system calls they're in."""
        self._table.update()  # a thread that has finished since the last update tells nothing
        threads = self._table.threads()
        calls = [thread.syscall for thread in threads if thread.syscall is not None]
        counted = all(len(_times_scheduled(thread).split()) == 3 for thread in threads)
        return bool(CALLS) and counted and bool(calls) and all(map(proc.system_call, calls))


def _times_scheduled(thread: Thread) -> bytes:
    return b"" if thread.schedstat is None else proc.times_scheduled(thread.schedstat)
