"""One place to run an answer: a process of its own with a warm observer, fed with jobs as lines of JSON.

    {"exercise": "09_joint_positions", "answer": "<program text>", "thorough": true}

comes in on standard input, judgements go out on standard output, the last one with `"final": true`. The line
`{"enough": true}` cuts short the real seconds that a passing program is kept running for.

    python -m workbook.grading.slot TIER [--user ID] [--try PORT]

The first line that goes out says that it is ready and, with `--try`, what is wrong with the tier, if anything is.
"""

import argparse
import contextlib
import ctypes
import json
import os
import queue
import signal
import sys
import threading
from dataclasses import replace
from pathlib import Path
from typing import Any, TextIO

from workbook.exercise.answers import Answer
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.exchange import judgement_to_json
from workbook.exercise.judging import Judge, Judgement
from workbook.observing.orphans import StillThere, adopt_orphans, sweep_orphans
from workbook.observing.self_test import try_out
from workbook.observing.tiers import Isolation, named_tier, walls
from workbook.observing.uids import Ids
from workbook.observing.warm_start import ForkServer, own_server
from workbook.observing.watch import Observer
from workbook.ros.environment import child_environment

PR_SET_PDEATHSIG = 1
PROCESSES = 64
"""Processes and threads of one answer; a node takes about 16."""
FILES = 20_000
"""Files and folders of one answer, in each of the three folders where it may write."""
LIMITS = {
    # Bytes, numbers, and seconds of processor time. No core file fits into one byte; with 0, a kernel that hands them
    # to a program would do so all the same.
    "memory": 2_500_000_000,
    "file_size": 100_000_000,
    "open_files": 512,
    "cpu": 60,
    "core": 1,
    "processes": PROCESSES,
}


def _private_output() -> TextIO:
    """Keep standard output for judgements alone; whatever else prints goes to standard error."""
    channel = os.fdopen(os.dup(1), "w", encoding="utf-8")
    os.dup2(2, 1)
    return channel


def _end_on_sigterm(*_: object) -> None:
    """End in order, and only once: a dying grader sends the signal again for each of its threads."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    raise SystemExit(0)


class _Inbox:
    """Reads standard input beside the work, so that a word can reach a job under way."""

    def __init__(self) -> None:
        self.jobs: queue.SimpleQueue[dict[str, Any] | None] = queue.SimpleQueue()
        self.enough = threading.Event()
        threading.Thread(target=self._read, name="inbox", daemon=True).start()

    def _read(self) -> None:
        for line in sys.stdin:
            message = json.loads(line)
            if "enough" in message:
                self.enough.set()
            else:
                self.jobs.put(message)
        self.enough.set()
        self.jobs.put(None)


def serve(isolation: Isolation, ids: Ids | None = None, port: int | None = None) -> None:
    """Answer jobs until standard input is closed. With "uid" the programs run under `ids`, which the caller leased.

    `port`: of a listener on this machine, for trying out the tier first.
    """
    channel = _private_output()
    adopt_orphans()
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, _end_on_sigterm)
    exercises: dict[str, Exercise] = {}
    inbox = _Inbox()

    def send(message: dict[str, Any]) -> None:
        channel.write(json.dumps(message, allow_nan=False) + "\n")
        channel.flush()

    def report(judgement: Judgement) -> None:
        send({"final": False, "judgement": judgement_to_json(judgement)})

    cage, confinement = walls(isolation, ids, adopts=True)
    server = ForkServer()
    limits = dict(LIMITS)
    if cage is not None:
        limits["files"] = FILES
        cage = replace(cage, server=server)
        server.start(cage.environment(child_environment(0, log_folder=Path(os.devnull))))
    else:
        own_server.keep()
    with contextlib.closing(server), Observer(cage=cage, confinement=confinement) as observer:
        judge = Judge(observer, limits)
        problem = None if port is None else try_out(isolation, observer, limits, port, ids)
        send({"ready": os.getpid(), "problem": problem})
        while (job := inbox.jobs.get()) is not None:
            inbox.enough.clear()
            try:
                stem = job["exercise"]
                if stem not in exercises:
                    exercises[stem] = load_exercise(stem)
                judgement = judge.judge(
                    exercises[stem],
                    Answer(job["answer"]),
                    thorough=job["thorough"],
                    report=report,
                    enough=inbox.enough.is_set,
                )
                message = {"final": True, "judgement": judgement_to_json(judgement)}
            except Exception as error:
                message = {"final": True, "error": f"{type(error).__name__}: {error}"}
            try:
                sweep_orphans()
            except StillThere as error:
                message = {"final": True, "error": str(error)}
            send(message)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("tier", type=named_tier)
    parser.add_argument("--user", type=lambda text: Ids(int(text)))
    parser.add_argument("--try", type=int, dest="port")
    asked = parser.parse_args()
    serve(asked.tier, asked.user, asked.port)


if __name__ == "__main__":
    main()
