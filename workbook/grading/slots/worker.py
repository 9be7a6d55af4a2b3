"""Run a slot: a process that judges one answer after another and keeps its observer ready in between.

    python -m workbook.grading.slots.worker TIER [--user ID] [--groups FOLDER] [--try PORT]

TIER is the isolation tier in which answers run. The process reads orders from standard input and writes judgments to
standard output. `protocol` describes these messages.
"""

import argparse
import contextlib
import json
import os
import queue
import signal
import sys
import threading
import time
from collections.abc import Callable, Sequence
from functools import cache
from itertools import islice
from pathlib import Path
from typing import BinaryIO

from workbook.exercise.answers import Answer
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.judgement import Judgement, Report
from workbook.exercise.judging import Judge
from workbook.grading.slots.protocol import (
    CANCEL_SOAK,
    JudgingOrder,
    Message,
    Progress,
    error_message,
    judgement_message,
    line_of,
    progress_message,
)
from workbook.inside.libc import set_parent_death_signal
from workbook.inside.orphans import StillThere, adopt_orphans, sweep_orphans
from workbook.isolation.sandbox import sandbox_environment
from workbook.isolation.tiers import Isolation, make_tier, named_tier
from workbook.isolation.user_ids import Ids
from workbook.programs.fork_client import ForkServer, ServerGone, own_server
from workbook.recording.limits import ANSWER_LIMITS
from workbook.ros.domains import NoDomainFree, lease_in_private
from workbook.ros.environment import child_environment
from workbook.watching.observer import Observer
from workbook.watching.recorder import Recorder
from workbook.watching.tier_self_test import try_out

PROGRESS_EVERY_S = 0.25
TOPICS_SHOWN = 8


def _private_output() -> BinaryIO:
    """Reserve standard output for judgments by redirecting all other output to standard error.

    Return the stream for judgments.
    """
    channel = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    return channel


def _end_on_sigterm(*_: object) -> None:
    """Exit in an orderly way. Ignore further SIGTERM signals.

    When our owner exits, we may get the signal once for each of its threads.
    """
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    raise SystemExit(0)


class _Inbox:
    """Reads standard input while a job is running, so that the owner can cancel the job's real-time watch."""

    def __init__(self) -> None:
        self.jobs: queue.SimpleQueue[JudgingOrder | None] = queue.SimpleQueue()
        self.cancel_soak = threading.Event()
        threading.Thread(target=self._read, name="inbox", daemon=True).start()

    def _read(self) -> None:
        for line in sys.stdin:
            message = json.loads(line)
            if message == CANCEL_SOAK:
                self.cancel_soak.set()
            else:
                self.jobs.put(JudgingOrder(**message))
        self.cancel_soak.set()
        self.jobs.put(None)


@cache
def _exercise(stem: str) -> Exercise:
    return load_exercise(stem)


def serve(
    isolation: Isolation,
    ids: Ids | None = None,
    port: int | None = None,
    groups: Path | None = None,
    servers: Sequence[ForkServer] = (),
) -> None:
    """Judge one job after another until standard input is closed.

    `ids`: the user IDs under which programs run in the "uid" tier, leased by the caller. `port`: the port of a listener
    on this machine, or None. If it's given, the tier is tested first. `groups`: the folder for memory cgroups, leased
    by the caller, or None. `servers`: the two servers from which programs are forked in the "sandbox" tier. If there
    are none, one is created.
    """
    channel = _private_output()
    adopt_orphans()
    set_parent_death_signal(signal.SIGTERM)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, _end_on_sigterm)
    inbox = _Inbox()

    def send(message: Message) -> None:
        channel.write(line_of(message))
        channel.flush()

    def report(judgement: Judgement) -> None:
        send(judgement_message(judgement, final=False))

    servers = servers or [ForkServer()]
    tier = make_tier(isolation, ids=ids, server=servers[0], alternate=servers[-1], groups=groups)
    warm_up(isolation, servers[0])
    with contextlib.ExitStack() as stack:
        for server in servers:
            stack.callback(server.close)
        try:
            observer = stack.enter_context(Observer(tier=tier))
        except NoDomainFree as error:
            send({"broken": str(error)})
            return
        judge = Judge(observer, ANSWER_LIMITS)
        problem = None if port is None else try_out(isolation, observer, ANSWER_LIMITS, port, ids)
        send({"ready": os.getpid(), "problem": problem})
        while (job := inbox.jobs.get()) is not None:
            inbox.cancel_soak.clear()
            observer.on_take = _ProgressSender(send) if job.progress else None
            send(_follow(job, judge, report, inbox.cancel_soak.is_set))


class _ProgressSender:
    """Sends a judgment's progress a few times per second."""

    def __init__(self, send: Callable[[Message], None]) -> None:
        self._send = send
        self._sent_at = -PROGRESS_EVERY_S

    def __call__(self, recorder: Recorder) -> None:
        if time.monotonic() - self._sent_at < PROGRESS_EVERY_S:
            return
        self._sent_at = time.monotonic()
        topics = [*islice(recorder.so_far(), TOPICS_SHOWN)]
        messages = {name: count for name, _, count, _ in topics}
        latest = {name: value for name, _, _, value in topics}
        types = {name: type_name for name, type_name, _, _ in topics}
        self._send(progress_message(Progress(0, round(recorder.simulated_now(), 3), messages, latest, types)))


def _follow(order: JudgingOrder, judge: Judge, report: Report, cancel_soak: Callable[[], bool]) -> Message:
    """Judge one answer, and kill its leftover processes. Return the last message: the judgment or an error.

    Raises ServerGone if a server that forks programs is gone. Then this slot exits, and its owner judges the answer on
    another one.
    """
    try:
        judgement = judge.judge(
            _exercise(order.exercise),
            Answer(order.answer),
            soak=order.soak,
            seed=order.seed,
            report=report,
            cancel_soak=cancel_soak,
        )
        message = judgement_message(judgement, final=True)
    except ServerGone:
        raise
    except Exception as error:
        message = error_message(f"{type(error).__name__}: {error}")
    try:
        sweep_orphans()
    except StillThere as error:
        message = error_message(str(error))
    return message


def warm_up(isolation: Isolation, server: ForkServer) -> None:
    """Start the server that forks programs: `server` in the "sandbox" tier, or else this process's own server.

    A slot in a sandbox has its own network, so it leases ROS domains independently of processes outside.
    """
    if isolation == "sandbox":
        lease_in_private()
        server.start(sandbox_environment(child_environment(0, log_folder=Path(os.devnull))))
    else:
        own_server.keep()


def main() -> None:
    """Parse the command line, and judge jobs until standard input is closed."""
    parser = argparse.ArgumentParser()
    parser.add_argument("tier", type=named_tier)
    parser.add_argument("--user", type=lambda text: Ids(int(text)))
    parser.add_argument("--groups", type=Path)
    parser.add_argument("--try", type=int, dest="port")
    asked = parser.parse_args()
    serve(asked.tier, asked.user, asked.port, asked.groups)


if __name__ == "__main__":
    main()
