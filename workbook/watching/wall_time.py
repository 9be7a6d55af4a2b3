"""Record a program in real time."""

import os
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from time import sleep

from workbook.inside.proc import process_tree, read, run_queue_s, stat_fields, tasks, thread_folder
from workbook.watching.session import Session
from workbook.watching.steal_time import StealTime

TAKE_EVERY_S = 0.05
LOOK_EVERY_S = 0.1
NOTE_EVERY_S = 0.2
UNSCRIPTED_PACE = 4.0
"""Without a script, we take messages less often, by this factor.

That does no harm, because messages carry their arrival times.
"""
OWN_LOAD_EVERY_S = 0.5
CONSTANTLY = 0.8
"""The fraction of all processors' time that a program's other threads must demand to count as filling the machine."""


def precedence(pid: int) -> tuple[int, ...]:
    """Return the nice value and scheduling policy of a process's first thread, or () if the process has exited."""
    try:
        fields = stat_fields(pid)
        return int(fields[16]), int(fields[38])
    except (OSError, IndexError):
        return ()


def wanted_processor_s(pids: Iterable[int]) -> dict[tuple[int, str], float]:
    """Return the seconds that each thread has spent running or waiting for a processor, by (process, thread)."""
    found = {}
    for pid in pids:
        for task in tasks(pid):
            with suppress(OSError, ValueError):
                ran, waited, *_ = map(int, read(f"{thread_folder(pid, task)}/schedstat").split())
                found[pid, task] = (ran + waited) / 1e9
    return found


class OwnLoad:
    """Detects whether a program itself is the reason why the first thread of its process `pid` waits for a processor.

    The program is the reason if its other threads demand enough CPU time to keep all processors busy. Whether they get
    that time doesn't matter, so a busy machine doesn't change the result. The program is also the reason if it has
    lowered its own priority.
    """

    def __init__(self, pid: int) -> None:
        self._pid = pid
        self._began = time.monotonic()
        self._before = wanted_processor_s(process_tree(pid))
        self._wanted: dict[tuple[int, str], float] = {}
        self._steps_back = False

    def note(self) -> None:
        """Poll the threads. Threads that have finished since the last poll keep their last value."""
        self._wanted |= wanted_processor_s(process_tree(self._pid))
        pairs = zip(precedence(self._pid), precedence(os.getpid()), strict=False)
        self._steps_back |= any(its > ours for its, ours in pairs)

    def is_to_blame(self) -> bool:
        """Return whether the program itself is the reason, judging by the polls so far."""
        return self._steps_back or self._fills_the_machine()

    def _fills_the_machine(self) -> bool:
        wanted = sum(
            seconds - self._before.get(thread, 0.0)
            for thread, seconds in self._wanted.items()
            if thread != (self._pid, str(self._pid))
        )
        there_were = len(os.sched_getaffinity(0)) * (time.monotonic() - self._began)
        return wanted > CONSTANTLY * there_were


def run_wall_time(session: Session, seconds: float, cancel_soak: Callable[[], bool] = lambda: False) -> None:
    """Record for `seconds` of real time, or until the program exits. Store delays in `session.delays`.

    Return early if `cancel_soak`, which is called about as often as messages are taken, or `is_lost` returns True.
    """
    process, recorder, script_player, delays = (
        session.process,
        session.recorder,
        session.script_player,
        session.delays,
    )
    end = time.monotonic() + seconds
    pace = 1.0 if session.plan.script else UNSCRIPTED_PACE
    next_take = next_look = next_note = next_load = 0.0
    before = queued = run_queue_s(process.pid)
    own_load = OwnLoad(process.pid)
    steal = StealTime()
    running = True
    while running and (left := end - time.monotonic()) > 0:
        paused = time.monotonic()
        turn = min(pace * TAKE_EVERY_S, left, script_player.until_next(session.simulated_time(paused)))
        sleep(turn)
        delays.held_up = max(delays.held_up, time.monotonic() - paused - turn)
        script_player.play(session.simulated_time(time.monotonic()), keep_pauses=True)
        if time.monotonic() > next_take:
            recorder.take()
            running = process.is_running() and not cancel_soak() and not is_lost(session)
            next_take = time.monotonic() + pace * TAKE_EVERY_S
        if time.monotonic() > next_note:
            process.note_processor_time()
            next_note = time.monotonic() + NOTE_EVERY_S
        if time.monotonic() > next_look:
            recorder.look()
            queued = max(queued, run_queue_s(process.pid))
            delays.longest_steal = max(delays.longest_steal, steal.longest_since_last())
            next_look = time.monotonic() + LOOK_EVERY_S
        if time.monotonic() > next_load:
            own_load.note()
            next_load = time.monotonic() + OWN_LOAD_EVERY_S
    if not own_load.is_to_blame():
        delays.run_queue += queued - before
    delays.stolen += steal.in_all()
    recorder.take()


def is_lost(session: Session) -> bool:
    """Return whether every topic with a judged rate is flooded, so a longer watch would show nothing more."""
    paced = session.plan.paced
    return bool(paced) and all(map(session.recorder.is_flooded, paced))


def left_to_watch(session: Session) -> float:
    """Return the wall time, in seconds, that remains until every judged topic has been watched as long as planned.

    The planned time starts when the last topic is matched, or `script_player.late_s` seconds after the watch began,
    whichever is later. New delays may move the start, so call this function until it returns zero or less.
    """
    now = session.simulated_time(time.monotonic())
    since = map(session.recorder.matched_at, session.plan.topics)
    latest = max((moment for moment in since if moment is not None), default=0.0)
    return max(latest, session.script_player.late_s) + session.plan.wall_s - now
