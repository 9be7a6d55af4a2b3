"""Judge many answers on this machine in parallel.

A slot is a process that judges answers. A place is the right to judge one answer, and its number is limited. A program
that only has to stay alive frees its place for the next answer.

After a program has been judged in simulated time, it's started again and watched for a few real seconds. That takes
little CPU time, so the next answer gets the program's place, and another slot judges that answer. With `fills`, more
answers than places run as long as processors would otherwise be idle. So the number of slots isn't fixed: it depends on
these watches, on `fills`, and on the available memory.
"""

import contextlib
import queue
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Generic

from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, Report
from workbook.grading.judges import Job, Key
from workbook.grading.slots import pool
from workbook.grading.slots.client import ShowProgress, Slot
from workbook.grading.slots.pool import Kind, SlotPool, warm_slots
from workbook.inside.proc import available_memory_bytes, idle_and_all_s
from workbook.isolation.tiers import Isolation, meets_others
from workbook.typechecking.typecheck import TypeCheckFailed, warm_cache

WAITING_PER_SLOT = 8
"""The maximum number of answers per slot that are in their real-time watch.

The watch takes 8 s, after about one second of work in the slot.
"""
MORE_PER_SLOT = 2
"""The maximum number of additional answers per slot that run while processors are idle.

This number is limited because a process in a container sees all processors, even if it may use only some of them.
"""
SPARE_SHARE = 0.25
"""The fraction of idle CPU time above which one more answer may start without slowing the others down."""
LOOK_S = 0.5
"""The time (s) for which the processors' idle time is measured before one more answer may start."""
SLOT_BYTES = 150_000_000
"""The memory that a slot and its program need, in bytes. Each of the two processes uses about 70 MB."""
KEPT_FREE_BYTES = 1_000_000_000
"""The memory to leave for other processes, in bytes. If less would remain, each place has only one slot."""


def fits_in_memory() -> bool:
    """Return whether there's enough memory for one more slot and its program."""
    return available_memory_bytes() > KEPT_FREE_BYTES + SLOT_BYTES


@dataclass(frozen=True)
class LocalSlots:
    """Judges `slots` answers in parallel on this machine. With `fills`, more run while processors are idle."""

    slots: int
    isolation: Isolation = "limits"
    fills: bool = False

    def judge_all(
        self, jobs: Iterable[Job[Key]], *, soak: bool = True, stop: Callable[[], bool] = lambda: False
    ) -> Iterator[tuple[Job[Key], Judgement]]:
        """See `GradingBackend`."""
        return judge_all(jobs, self.slots, soak=soak, isolation=self.isolation, stop=stop, fills=self.fills)


class IdleProcessors:
    """Measures whether this machine's processors are idle for a part of the time."""

    def __init__(self) -> None:
        self._looked_at = -LOOK_S
        self._before: tuple[float, float] | None = None

    def __call__(self) -> bool:
        """Return whether at least the fraction SPARE_SHARE of the CPU time since the last measurement was idle.

        If the last measurement is less than LOOK_S seconds old, don't measure, and return False.
        """
        if time.monotonic() - self._looked_at < LOOK_S:
            return False
        now = idle_and_all_s()
        since = now if self._before is None else self._before
        idle, passed = (later - before for later, before in zip(now, since, strict=True))
        self._looked_at, self._before = time.monotonic(), now
        return idle >= SPARE_SHARE * passed > 0


class WorkPermits:
    """Limits the work to `at_work` answers in parallel, each on its own slot. Thread-safe.

    `warm`: a function that returns a warm slot, or None if there is none. `room`: a function that takes the current
    number of slots and returns whether one more slot may be started beyond the first `at_work`. `spare`: a function
    that's polled and returns whether one more answer may run beyond `at_work`, or None if that's never allowed.
    """

    def __init__(
        self,
        at_work: int,
        warm: Callable[[], Slot | None],
        room: Callable[[int], bool],
        spare: Callable[[], bool] | None = None,
    ) -> None:
        self._free = self._at_work = at_work
        self._warm = warm
        self._room = room
        self._spare = spare
        self._slots = 0
        self._changed = threading.Condition()

    def take(self) -> "Permit":
        """Wait for a permit, and return it."""
        with self._changed:
            while True:
                if self._may_work():
                    slot = self._warm()
                    if slot is not None or self._slots < self._at_work or self._room(self._slots):
                        self._free -= 1
                        self._slots += slot is None
                        return Permit(self, slot)
                self._changed.wait(None if self._spare is None else LOOK_S)

    def _may_work(self) -> bool:
        if self._free <= -MORE_PER_SLOT * self._at_work:
            return False
        return self._free > 0 or (self._spare is not None and self._spare())

    def change(self, *, free: int = 0, slots: int = 0) -> None:
        """Increase the number of free permits by `free`, and the number of slots by `slots`."""
        with self._changed:
            self._free += free
            self._slots += slots
            self._changed.notify_all()


class Permit:
    """A permit to judge an answer on `slot` or, if `slot` is None, on a new slot."""

    def __init__(self, permits: WorkPermits, slot: Slot | None) -> None:
        self.slot = slot
        self._permits = permits
        self._is_held = True

    def end(self) -> None:
        """Release the permit. If it has already been released, do nothing."""
        self._permits.change(free=int(self._is_held))
        self._is_held = False

    def judge(
        self,
        slots: SlotPool,
        kind: Kind,
        job: Job[Key],
        *,
        soak: bool,
        report: Report | None = None,
        progress: ShowProgress | None = None,
    ) -> Judgement:
        """Judge a job, and then give back the permit and the slot.

        The permit is released before this method returns, as soon as a judgment that isn't provisional is reported.
        After that, only the real-time watch follows.
        """
        slot = self.slot

        def reported(judgement: Judgement) -> None:
            if not judgement.provisional:
                self.end()
            if report is not None:
                report(judgement)

        try:
            slot, judgement = pool.judge_with_retry(
                slots, slot, kind, job, soak=soak, report=reported, progress=progress
            )
            return judgement
        finally:
            self.give_back(slots, kind, slot)

    def give_back(self, slots: SlotPool, kind: Kind, slot: Slot | None) -> None:
        """Return the slot to the pool for the next answer, and release the permit.

        `slot`: the slot, or None if it no longer exists.
        """
        if slot is None:
            self._permits.change(slots=-1)
        else:
            slots.give(kind, slot)
        self.end()


def judge_all(
    jobs: Iterable[Job[Key]],
    slots: int,
    *,
    soak: bool = True,
    isolation: Isolation = "limits",
    stop: Callable[[], bool] = lambda: False,
    fills: bool = False,
) -> Iterator[tuple[Job[Key], Judgement]]:
    """Judge many answers, `slots` of them in parallel. Yield each judgment as soon as it's ready.

    With `fills`, more answers run while processors would otherwise be idle. In an isolation tier in which answers could
    reach each other (see `meets_others`), answers are judged one at a time, regardless of `slots`. `stop` is called
    before each new answer. Once it returns True, no new answer is started, and this function returns after the
    judgments in progress.
    """
    run = _AnswersOfRun(list(jobs), max(1, slots), soak, isolation, stop, fills)
    threads = [
        threading.Thread(target=run.work, name=f"answer {number}") for number in range(run.most_at_once)
    ]
    for thread in threads:
        thread.start()
    try:
        for _ in threads:
            yield from iter(run.done.get, None)
    finally:
        run.forget_the_rest()
        for thread in threads:
            thread.join()
        run.close()


class _AnswersOfRun(Generic[Key]):
    """The answers passed to one `judge_all` call, and the state of judging them.

    `done`: the queue that receives each judgment, and None from each thread when it finishes.
    """

    def __init__(
        self,
        jobs: Sequence[Job[Key]],
        slots: int,
        soak: bool,
        isolation: Isolation,
        stop: Callable[[], bool],
        fills: bool,
    ) -> None:
        self._waiting: queue.SimpleQueue[Job[Key]] = queue.SimpleQueue()
        self._soak = soak
        self._kind = Kind(isolation)
        self._stop = stop
        self.done: queue.SimpleQueue[tuple[Job[Key], Judgement] | None] = queue.SimpleQueue()
        self._are_idle = IdleProcessors()
        self._pool = SlotPool()
        self._permits = WorkPermits(slots, self._warm, self._has_room, self._has_spare if fills else None)
        for_each = 1 + (WAITING_PER_SLOT if soak else 0) + (MORE_PER_SLOT if fills else 0)
        self.most_at_once = min(slots * for_each, max(1, len(jobs)))
        if meets_others(isolation):
            self.most_at_once = 1  # even an answer in its real-time watch could send messages to another
        for job in jobs:
            self._waiting.put(job)
        _prepare_for({job.stem for job in jobs})
        if warm_slots.move(self._kind, self._pool):
            self._permits.change(slots=1)
        self._server = self._pool.fork_from_now_on(self._kind) if len(jobs) > 1 else None

    def _has_room(self, present: int) -> bool:
        """Return whether to start another slot when `present` slots exist.

        Another slot isn't worthwhile if few answers are waiting, because starting one takes as long as judging an
        answer.
        """
        return self._waiting.qsize() >= present and fits_in_memory()

    def _has_spare(self) -> bool:
        """Return whether processors are idle enough for one more answer.

        Return False until the server has forked the first slot, because the answers that wait for slots will need the
        processors soon.
        """
        return (self._server is None or self._server.is_tried) and self._are_idle()

    def _warm(self) -> Slot | None:
        return self._pool.take_warm(self._kind)

    def forget_the_rest(self) -> None:
        """Drop the answers that haven't been started."""
        while self._next() is not None:
            pass

    def _next(self) -> Job[Key] | None:
        try:
            return self._waiting.get_nowait()
        except queue.Empty:
            return None

    def work(self) -> None:
        """Judge one answer after another until none is waiting. This method runs in each thread."""
        try:
            while not self._waiting.empty() and not self._stop():
                self._judge_next(self._permits.take())
        finally:
            self.done.put(None)

    def _judge_next(self, permit: Permit) -> None:
        job = None if self._stop() else self._next()
        if job is None:
            permit.give_back(self._pool, self._kind, permit.slot)
            return
        self.done.put((job, permit.judge(self._pool, self._kind, job, soak=self._soak)))

    def close(self) -> None:
        """Stop all slots and the servers that forked them."""
        self._pool.close()


def _prepare_for(stems: Iterable[str]) -> None:
    """Fill mypy's cache if answers will be type-checked. Slots start only afterward, because they can't write to it."""
    if any(_is_type_checked(stem) for stem in stems):
        with contextlib.suppress(TypeCheckFailed):  # judging will report the failure
            warm_cache()


def _is_type_checked(stem: str) -> bool:
    try:
        return load_exercise(stem).source.kind == "static"
    except Exception:  # judging will report the problem
        return False
