"""Judging many answers on this machine: some at work at once, and beside them those that are watched in real time.

A program that simulated time has judged is started again, and watched for some real seconds. That is little work:
meanwhile its place is given to the next answer, which is judged by another slot. And where that is wanted, more answers
than there are places are at work while the processors would be idle otherwise. How many slots there are follows from
that and from memory.
"""

import contextlib
import queue
import threading
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Generic

from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement
from workbook.grading.judges import Job, Key
from workbook.grading.slots import pool
from workbook.grading.slots.client import Slot
from workbook.grading.slots.pool import Kind, SlotPool, warm_slots
from workbook.inside.proc import available_memory_bytes, idle_and_all_s
from workbook.isolation.tiers import Isolation, meets_others
from workbook.typechecking.typecheck import TypeCheckFailed, warm_cache

WAITING_PER_PLACE = 8
"""Slots beside each place whose answers only wait. They wait for 8 s, and are at work for about one."""
MORE_PER_PLACE = 2
"""Answers beside each place that are at work only because processors were idle: no more, however idle they are. Who has
only a part of the processors, in a container, sees all of them."""
SPARE_SHARE = 0.25
"""Where the processors were idle for a smaller share of the time, one more answer would make the others wait."""
LOOK_S = 0.5
"""One more answer at a time: so long it is watched how busy they are with it."""
SLOT_BYTES = 150_000_000
"""A slot with a program: the slot holds some 70 MB of its own, a program about as much."""
KEPT_FREE_BYTES = 1_000_000_000
"""Memory that is left to all others: no slot is added below it, except for the places themselves."""


@dataclass(frozen=True)
class LocalSlots:
    """Judges on this machine, `slots` answers at work at once; where `fills`, more while processors are idle."""

    slots: int
    isolation: Isolation = "limits"
    fills: bool = False

    def judge_all(
        self, jobs: Iterable[Job[Key]], *, soak: bool = True, stop: Callable[[], bool] = lambda: False
    ) -> Iterator[tuple[Job[Key], Judgement]]:
        """See `GradingBackend`."""
        return judge_all(jobs, self.slots, soak=soak, isolation=self.isolation, stop=stop, fills=self.fills)


class IdleProcessors:
    """Tells now and then whether the processors of this machine have nothing to do for a part of the time."""

    def __init__(self) -> None:
        self._looked_at = -LOOK_S
        self._before: tuple[float, float] | None = None

    def __call__(self) -> bool:
        """Whether they were idle for SPARE_SHARE of the time since the last look; at most every LOOK_S seconds."""
        if time.monotonic() - self._looked_at < LOOK_S:
            return False
        now = idle_and_all_s()
        since = now if self._before is None else self._before
        idle, passed = (later - before for later, before in zip(now, since, strict=True))
        self._looked_at, self._before = time.monotonic(), now
        return idle >= SPARE_SHARE * passed > 0


class WorkPermits:
    """Who may be at work: `at_work` answers at once, each with a slot of the pool. For use by several threads.

    `room`: whether one more slot may be started beside the first `at_work`, of which there are so many now. `spare`:
    asked again and again whether one more answer may be at work beside them.
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
        """Wait for a permit."""
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
        if self._free <= -MORE_PER_PLACE * self._at_work:
            return False
        return self._free > 0 or (self._spare is not None and self._spare())

    def change(self, *, free: int = 0, slots: int = 0) -> None:
        """Take note that so many more may work, or that there are so many more slots."""
        with self._changed:
            self._free += free
            self._slots += slots
            self._changed.notify_all()


class Permit:
    """To be at work, with `slot`, or with a new one where that is None."""

    def __init__(self, permits: WorkPermits, slot: Slot | None) -> None:
        self.slot = slot
        self._permits = permits
        self._is_held = True

    def end(self) -> None:
        """Let somebody else work; does nothing the second time."""
        self._permits.change(free=int(self._is_held))
        self._is_held = False

    def end_when_watched(self, judgement: Judgement) -> None:
        """End when a judgement is reported that is not provisional: only real seconds follow."""
        if not judgement.provisional:
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
    """Judge many answers, `slots` of them at work at once; yields each judgement as it is ready.

    With `fills` more of them are at work while the processors are idle otherwise.
    In a tier in which answers meet each other they are judged one after another, whatever `slots` says.
    `stop` is asked before each new answer, so that an interrupted run ends after those under way.
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
    """Answers of one call of `judge_all`. `done` gets each judgement, and None from each thread that ends."""

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
        self._thorough = soak
        self._kind = Kind(isolation)
        self._stop = stop
        self.done: queue.SimpleQueue[tuple[Job[Key], Judgement] | None] = queue.SimpleQueue()
        self._are_idle = IdleProcessors()
        self._pool = SlotPool()
        self._permits = WorkPermits(slots, self._warm, self._has_room, self._has_spare if fills else None)
        for_each = 1 + (WAITING_PER_PLACE if soak else 0) + (MORE_PER_PLACE if fills else 0)
        self.most_at_once = min(slots * for_each, max(1, len(jobs)))
        if meets_others(isolation):
            self.most_at_once = 1  # beside it, an answer that only waits could still speak to the others
        for job in jobs:
            self._waiting.put(job)
        _prepare_for({job.stem for job in jobs})
        if warm_slots.move(self._kind, self._pool):
            self._permits.change(slots=1)
        self._server = self._pool.fork_from_now_on(self._kind) if len(jobs) > 1 else None

    def _has_room(self, present: int) -> bool:
        """To start a slot takes as long as to judge an answer: it must be worth that."""
        return self._waiting.qsize() >= present and available_memory_bytes() > KEPT_FREE_BYTES + SLOT_BYTES

    def _has_spare(self) -> bool:
        """What only waits for the server of the slots leaves the processors idle, and will soon need them."""
        return (self._server is None or self._server.is_tried) and self._are_idle()

    def _warm(self) -> Slot | None:
        return self._pool.take_warm(self._kind)

    def forget_the_rest(self) -> None:
        """Begin no more answers."""
        while self._next() is not None:
            pass

    def _next(self) -> Job[Key] | None:
        try:
            return self._waiting.get_nowait()
        except queue.Empty:
            return None

    def work(self) -> None:
        """Judge one answer after another until none is left."""
        try:
            while not self._waiting.empty() and not self._stop():
                self._judge_next(self._permits.take())
        finally:
            self.done.put(None)

    def _judge_next(self, permit: Permit) -> None:
        slot = permit.slot
        try:
            job = None if self._stop() else self._next()
            if job is not None:
                slot, judgement = pool.judge_with_retry(
                    self._pool,
                    slot,
                    self._kind,
                    job,
                    soak=self._thorough,
                    report=permit.end_when_watched,
                )
                self.done.put((job, judgement))
        finally:
            if slot is None:
                self._permits.change(slots=-1)
            else:
                self._pool.give(self._kind, slot)
            permit.end()

    def close(self) -> None:
        """End all slots, and what they were forked from."""
        self._pool.close()


def _prepare_for(stems: Iterable[str]) -> None:
    """Let the type checker see our packages once, before slots start that cannot write down what it learned."""
    if any(_is_type_checked(stem) for stem in stems):
        with contextlib.suppress(TypeCheckFailed):  # those who judge will say it
            warm_cache()


def _is_type_checked(stem: str) -> bool:
    try:
        return load_exercise(stem).source.kind == "static"
    except Exception:  # what is wrong with it, its judgements tell
        return False
