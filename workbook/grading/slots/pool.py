"""Keep a pool of warm slots, and judge answers on them. If a slot breaks, use another one.

A slot is a process that judges answers. It's warm if it's ready for the next answer.
"""

import atexit
import fcntl
import os
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement, Report
from workbook.grading.judges import Job, Key
from workbook.grading.slots.client import (
    NotBegun,
    ShowProgress,
    Slot,
    SlotBroken,
    SlotServer,
    slot_environment,
)
from workbook.grading.slots.protocol import Progress
from workbook.isolation.bubblewrap import NoSandbox
from workbook.isolation.tiers import Isolation, meets_others

FORKED: tuple[Isolation, ...] = ("sandbox", "limits")
"""The isolation tiers in which many slots run at the same time.

In the other tiers, only one slot runs at a time, so a server that forks slots would cost more time than it saves.
"""
TRIES = 2
STOPPED_JUDGE = "stopped_judge"
"""The prefix of the reason if an answer is ungradable because slots break on it but can judge a correct answer."""
LOOK = "Look at it yourself: it is not run again as long as it stays the same, unless you ask with --retry-stopped"


class Kind(NamedTuple):
    """The properties of a slot that must match a job before the slot can judge it.

    See `Slot` for their meaning.
    """

    isolation: Isolation = "limits"
    own_criteria: Path | None = None


@dataclass(frozen=True)
class _Idle:
    kind: Kind
    slot: Slot
    since: float


class SlotPool:
    """Keeps slots warm between answers, and keeps the servers that fork them. Thread-safe.

    A slot that has been idle for longer than `idle_s` seconds is stopped. If `idle_s` is None, slots are kept until the
    pool is closed. A slot that wasn't forked exits when the thread that started it finishes.
    """

    def __init__(self, idle_s: float | None = None) -> None:
        self._idle_s = idle_s
        self._idle: list[_Idle] = []
        self._at_work: dict[Slot, Kind] = {}
        self._servers: dict[Kind, SlotServer | None] = {}
        self._starting: list[Kind] = []
        self._turn = threading.Lock()
        self._changed = threading.Condition()
        self._keeper: threading.Thread | None = None
        self._owner = os.getpid()

    def fork_from_now_on(self, kind: Kind) -> SlotServer | None:
        """Fork new slots of this kind from a server from now on. Return the server.

        Return None if forking is impossible or not worthwhile (see `slot_server`).
        """
        with self._turn:
            server = self._servers.get(kind)
            if server is not None and not server.is_running:
                server.close()
                server = None
            if server is None:
                server = slot_server(*kind)
                with self._changed:
                    self._servers[kind] = server
            return server

    def take_warm(self, kind: Kind) -> Slot | None:
        """Return an idle slot that's still running and has the current environment, or None if there is none."""
        while True:
            with self._changed:
                found = next((one for one in reversed(self._idle) if one.kind == kind), None)
                if found is None:
                    return None
                self._idle.remove(found)
                if found.slot.is_running and found.slot.environ == slot_environment(kind.own_criteria):
                    self._at_work[found.slot] = kind
                    return found.slot
            found.slot.close()

    def take(self, kind: Kind) -> Slot:
        """Return a warm slot if there is one. Otherwise, start one (see `start`)."""
        return self.take_warm(kind) or self.start(kind)

    def start(self, kind: Kind) -> Slot:
        """Start a new slot and return it. Raises SlotBroken if no user ID is free for the "uid" tier."""
        with self._changed:
            self._starting.append(kind)
            server = self._servers.get(kind)
        try:
            slot = Slot(*kind, server=server)
            with self._changed:
                self._at_work[slot] = kind
        finally:
            with self._changed:
                self._starting.remove(kind)
        return slot

    def give(self, kind: Kind, slot: Slot) -> None:
        """Put a slot that has finished its work back into the pool, where it waits for the next answer."""
        with self._changed:
            self._at_work.pop(slot, None)
            self._idle.append(_Idle(kind, slot, time.monotonic()))
            if self._keeper is None and self._idle_s is not None:
                self._keeper = threading.Thread(target=self._keep, name="keeper of slots", daemon=True)
                self._keeper.start()
            self._changed.notify_all()

    def drop(self, slot: Slot) -> None:
        """Remove a broken slot from the pool, and kill it."""
        with self._changed:
            self._at_work.pop(slot, None)
        slot.kill()

    def warm_up(self, kind: Kind) -> None:
        """Make sure that a slot of this kind is warm. Do nothing if a slot of this kind is judging now."""
        with self._changed:
            is_at_work = kind in self._at_work.values()
        if not is_at_work:
            self.give(kind, self.take(kind))

    def move(self, kind: Kind, other: "SlotPool") -> bool:
        """Move a warm slot of this kind to another pool. Return False if there is none."""
        slot = self.take_warm(kind)
        if slot is None:
            return False
        with self._changed:
            self._at_work.pop(slot)
        other.give(kind, slot)
        return True

    def cancel_soak(self) -> None:
        """Cancel the real-time watches of the slots that are judging now."""
        with self._changed:
            at_work = [*self._at_work]
        for slot in at_work:
            slot.cancel_soak()

    def close(self) -> None:
        """Stop all slots in parallel, and then the servers. Kill the slots that are still judging."""
        if self._owner != os.getpid():  # in a forked process, these slots belong to the parent
            return
        with self._changed:
            idle, self._idle = self._idle, []
            at_work, servers = [*self._at_work], [*self._servers.values()]
            self._at_work.clear()
            self._servers.clear()
        ending = [threading.Thread(target=slot.kill) for slot in at_work]
        ending += [threading.Thread(target=one.slot.close) for one in idle]
        for thread in ending:
            thread.start()
        for thread in ending:
            thread.join()
        for server in servers:
            if server is not None:
                server.close()

    def _keep(self) -> None:
        while True:
            for one in self._overdue():
                one.close()

    def _overdue(self) -> list[Slot | SlotServer]:
        """Wait until a slot has been idle for too long.

        Return that slot and the servers that don't have any slots left.
        """
        assert self._idle_s is not None
        with self._changed:
            while not self._idle or self._idle[0].since + self._idle_s > time.monotonic():
                left = self._idle[0].since + self._idle_s - time.monotonic() if self._idle else None
                self._changed.wait(left)
            found: list[Slot | SlotServer] = [self._idle.pop(0).slot]
            used = {*self._starting, *self._at_work.values(), *(one.kind for one in self._idle)}
            for kind in [*self._servers]:
                if kind not in used and (server := self._servers.pop(kind)) is not None:
                    found.append(server)
            return found


def slot_server(isolation: Isolation, own_criteria: Path | None = None) -> SlotServer | None:
    """Start a server that forks slots.

    Return None if starting it fails or if a server isn't worthwhile in this tier (see `FORKED`).
    """
    if isolation not in FORKED:
        return None
    try:
        return SlotServer(isolation, slot_environment(own_criteria))
    except (OSError, NoSandbox):
        return None


warm_slots = SlotPool()
"""The slots for judging one answer at a time. A run over many answers has its own pool."""
atexit.register(warm_slots.close)


_line: list[object] = []
_line_moves = threading.Condition()


def _file_of_turns() -> Path:
    cache = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return Path(cache) / "rclpy-workbook" / f"turn-{os.uname().nodename}"


@contextmanager
def turn(isolation: Isolation, show_place: Callable[[int], None] = lambda _: None) -> Iterator[None]:
    """Wait until no other answer is being judged by this user on this machine, and keep others waiting.

    Use it as a context manager. It waits only in a tier in which untrusted answers could reach each other (see
    `meets_others`). There, an answer could publish on another answer's domain, or lease all domains. A turn is a file
    lock, so the kernel releases it when the process that holds it exits. If the cache folder isn't writable, answers
    take turns only within this process. `show_place` is called with the number of answers ahead. It counts the answers
    that wait in this process, and at most one in another process.
    """
    if not meets_others(isolation):
        yield
        return
    ticket = object()
    with _line_moves:
        _line.append(ticket)
    held = None
    try:
        _wait_for_first_place(ticket, show_place)
        held = _open_file()
        if held is not None:
            _lock(held, show_place)
        show_place(0)
        yield
    finally:
        if held is not None:
            os.close(held)  # closing releases the lock
        with _line_moves:
            _line.remove(ticket)
            _line_moves.notify_all()


def _wait_for_first_place(ticket: object, show_place: Callable[[int], None]) -> None:
    with _line_moves:
        while (place := _line.index(ticket)) > 0:
            show_place(place)
            _line_moves.wait()


def _lock(file: int, show_place: Callable[[int], None]) -> None:
    with suppress(OSError):  # the file system may not support locks
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            show_place(1)
            fcntl.flock(file, fcntl.LOCK_EX)


def _open_file() -> int | None:
    path = _file_of_turns()
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        return os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC | os.O_NOFOLLOW, 0o600)
    except OSError:
        return None


def judge_warm(
    pool: SlotPool,
    kind: Kind,
    job: Job[Key],
    *,
    soak: bool,
    report: Report | None = None,
    progress: ShowProgress | None = None,
) -> Judgement:
    """Judge an answer on a slot from the pool, and put the slot back afterward. See `judge_with_retry`."""
    slot, judgement = judge_with_retry(
        pool, pool.take_warm(kind), kind, job, soak=soak, report=report, progress=progress
    )
    if slot is not None:
        pool.give(kind, slot)
    return judgement


def judge_with_retry(
    pool: SlotPool,
    slot: Slot | None,
    kind: Kind,
    job: Job[Key],
    *,
    soak: bool,
    report: Report | None = None,
    progress: ShowProgress | None = None,
) -> tuple[Slot | None, Judgement]:
    """Judge a job on `slot`, which was taken from the pool, or on a new slot.

    If the slot breaks, try once more on another. If both slots break on this answer but a new slot can judge a correct
    answer, this answer is the cause. Then the judgment is `ungradable`, and its reason begins with `STOPPED_JUDGE`.
    Otherwise, the error is ours, and the judgment is an `infra_error`. Return the judgment together with the slot for
    further answers, or with None after an `infra_error` of this kind.
    """
    reason = ""
    stopped = 0

    def show_place(place: int) -> None:
        if progress is not None:
            progress(Progress(place))

    with turn(kind.isolation, show_place):
        for _ in range(TRIES):
            at_work = False
            try:
                slot = slot or pool.start(kind)
                at_work = True
                return slot, slot.judge(
                    job.stem, job.answer, soak=soak, seed=job.seed, report=report, progress=progress
                )
            except Exception as error:  # whatever the exception, the answer must not be lost
                reason = str(error) or type(error).__name__
                stopped += at_work and isinstance(error, SlotBroken) and not isinstance(error, NotBegun)
                if slot is not None:
                    pool.drop(slot)
                slot = None
        if stopped == TRIES and (slot := _slot_that_judges(job.stem, pool, kind)) is not None:
            told = f"{STOPPED_JUDGE}: {reason}, {TRIES} times with this answer, and then judged a right one. {LOOK}"
            return slot, Judgement(job.stem, job.answer.sha256, "ungradable", told, (), None)
    reason += f", {TRIES} times with this answer. Run the command again; if it fails again, look at the answer yourself"
    return None, Judgement(job.stem, job.answer.sha256, "infra_error", reason, (), None)


def _slot_that_judges(stem: str, pool: SlotPool, kind: Kind) -> Slot | None:
    """Return a new slot that has just judged the reference answer, or None if that's impossible."""
    slot: Slot | None = None
    try:
        right = load_exercise(stem).source.solution_code
        slot = pool.start(kind)
        if slot.judge(stem, Answer(right), soak=False).status == "graded":
            return slot
    except Exception:  # whatever failed here doesn't prove that the answer is the cause
        pass
    if slot is not None:
        pool.drop(slot)
    return None
