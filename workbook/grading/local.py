"""Judging many answers on this machine: some at work at once, and beside them those that only have to stay alive.

A program that has passed on robot time is kept alive for some real seconds. That is no work: meanwhile its place is
given to the next answer, which is judged by another slot. And where that is wanted, more answers than there are places
are at work while the processors would be idle otherwise. How many slots there are follows from that and from memory.
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
from workbook.grading import pool
from workbook.grading.judges import Job, Key
from workbook.grading.pool import Slot
from workbook.grading.warm_slots import FORKED, SlotServer
from workbook.inside.proc import available_memory_bytes, idle_and_all_s
from workbook.isolation.bubblewrap import NoSandbox
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
        self, jobs: Iterable[Job[Key]], *, thorough: bool = True, stop: Callable[[], bool] = lambda: False
    ) -> Iterator[tuple[Job[Key], Judgement]]:
        """See `Judges`."""
        return judge_all(
            jobs, self.slots, thorough=thorough, isolation=self.isolation, stop=stop, fills=self.fills
        )


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


class Places:
    """Who may be at work: `at_work` answers at once, each with a slot. For use by several threads.

    `room`: whether one more slot may be started beside the first `at_work`, of which there are so many now. `spare`:
    asked again and again whether one more answer may be at work beside them.
    """

    def __init__(
        self, at_work: int, room: Callable[[int], bool], spare: Callable[[], bool] | None = None
    ) -> None:
        self._free = self._at_work = at_work
        self._room = room
        self._spare = spare
        self._slots = 0
        self._idle: list[Slot] = []
        self._changed = threading.Condition()

    def take(self) -> Slot | None:
        """Wait for a place. Returns a warm slot, or None where a new one is to be started."""
        with self._changed:
            while not self._can_begin():
                self._changed.wait(None if self._spare is None else LOOK_S)
            self._free -= 1
            if self._idle:
                return self._idle.pop()
            self._slots += 1
            return None

    def _can_begin(self) -> bool:
        if self._free <= -MORE_PER_PLACE * self._at_work:
            return False
        if not self._idle and self._slots >= self._at_work and not self._room(self._slots):
            return False
        return self._free > 0 or (self._spare is not None and self._spare())

    def leave(self) -> None:
        """The answer in this place only waits from now on, or is done: somebody else may work."""
        with self._changed:
            self._free += 1
            self._changed.notify_all()

    def give_back(self, slot: Slot | None) -> None:
        """A slot has nothing to do any more; None: it is broken."""
        with self._changed:
            if slot is None:
                self._slots -= 1
            else:
                self._idle.append(slot)
            self._changed.notify_all()

    def close(self) -> None:
        """End all slots, side by side."""
        closing = [threading.Thread(target=slot.close) for slot in self._idle]
        for thread in closing:
            thread.start()
        for thread in closing:
            thread.join()


def judge_all(
    jobs: Iterable[Job[Key]],
    slots: int,
    *,
    thorough: bool = True,
    isolation: Isolation = "limits",
    stop: Callable[[], bool] = lambda: False,
    fills: bool = False,
) -> Iterator[tuple[Job[Key], Judgement]]:
    """Judge many answers, `slots` of them at work at once; yields each judgement as it is ready.

    With `fills` more of them are at work while the processors are idle otherwise.
    In a tier in which answers meet each other they are judged one after another, whatever `slots` says.
    `stop` is asked before each new answer, so that an interrupted run ends after those under way.
    """
    run = _Run(list(jobs), max(1, slots), thorough, isolation, stop, fills)
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


class _Run(Generic[Key]):
    """Answers of one call of `judge_all`. `done` gets each judgement, and None from each thread that ends."""

    def __init__(
        self,
        jobs: Sequence[Job[Key]],
        slots: int,
        thorough: bool,
        isolation: Isolation,
        stop: Callable[[], bool],
        fills: bool,
    ) -> None:
        self._waiting: queue.SimpleQueue[Job[Key]] = queue.SimpleQueue()
        self._thorough = thorough
        self._isolation = isolation
        self._stop = stop
        self.done: queue.SimpleQueue[tuple[Job[Key], Judgement] | None] = queue.SimpleQueue()
        self._are_idle = IdleProcessors()
        self.places = Places(slots, self._has_room, self._has_spare if fills else None)
        for_each = 1 + (WAITING_PER_PLACE if thorough else 0) + (MORE_PER_PLACE if fills else 0)
        self.most_at_once = min(slots * for_each, max(1, len(jobs)))
        if meets_others(isolation):
            self.most_at_once = 1  # beside it, an answer that only waits could still speak to the others
        for job in jobs:
            self._waiting.put(job)
        _prepare_for({job.stem for job in jobs})
        self._server = slot_server(isolation) if len(jobs) > 1 else None

    def _has_room(self, present: int) -> bool:
        """To start a slot takes as long as to judge an answer: it must be worth that."""
        return self._waiting.qsize() >= present and available_memory_bytes() > KEPT_FREE_BYTES + SLOT_BYTES

    def _has_spare(self) -> bool:
        """What only waits for the server of the slots leaves the processors idle, and will soon need them."""
        return (self._server is None or self._server.is_tried) and self._are_idle()

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
                self._judge_next(self.places.take(), _Place(self.places))
        finally:
            self.done.put(None)

    def _judge_next(self, slot: Slot | None, place: "_Place") -> None:
        try:
            job = None if self._stop() else self._next()
            if job is not None:
                slot, judgement = pool.judge_with_retry(
                    slot,
                    job,
                    self._thorough,
                    self._isolation,
                    report=place.leave_to_wait,
                    server=self._server,
                )
                self.done.put((job, judgement))
        finally:
            self.places.give_back(slot)
            place.leave()

    def close(self) -> None:
        """End all slots, and what they were forked from."""
        self.places.close()
        if self._server is not None:
            self._server.close()


def slot_server(isolation: Isolation) -> SlotServer | None:
    """What slots are forked from; None in a tier where that is not worth its start, or not possible."""
    if isolation not in FORKED:
        return None
    try:
        return SlotServer(isolation, pool.slot_environment(None))
    except (OSError, NoSandbox):
        return None


class _Place:
    """One of the places, as long as an answer needs it."""

    def __init__(self, places: Places) -> None:
        self._places: Places | None = places

    def leave(self) -> None:
        """Let somebody else work here; does nothing the second time."""
        places, self._places = self._places, None
        if places is not None:
            places.leave()

    def leave_to_wait(self, judgement: Judgement) -> None:
        """Leave when a judgement is reported that is not provisional: the program is only kept alive from then on."""
        if not judgement.provisional:
            self.leave()


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
