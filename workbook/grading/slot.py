"""One place to run an answer: a process of its own with a warm observer, fed with jobs as lines of JSON.

    {"exercise": "09_joint_positions", "answer": "<program text>", "thorough": true,
     "seed": null}

comes in on standard input, judgements go out on standard output, the last one with `"final": true`. The line
`{"enough": true}` cuts short the real seconds that a passing program is kept running for.

    python -m workbook.grading.slot TIER [--user ID] [--groups FOLDER] [--try PORT]

The first line that goes out says that it is ready and, with `--try`, what is wrong with the tier, if anything is. If it
cannot begin, the line says why: `{"broken": "No ROS domain is free…"}`.
"""

import argparse
import contextlib
import json
import os
import queue
import signal
import sys
import threading
from collections.abc import Callable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any, TextIO

from workbook.exercise.answers import Answer
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.judgement import Judgement, Report
from workbook.exercise.judging import Judge
from workbook.exercise.serialization import judgement_to_json
from workbook.inside.libc import set_parent_death_signal
from workbook.inside.orphans import StillThere, adopt_orphans, sweep_orphans
from workbook.isolation.sandbox import sandbox_environment
from workbook.isolation.tiers import Isolation, make_tier, named_tier
from workbook.isolation.user_ids import Ids
from workbook.programs.warm_start import ForkServer, ServerGone, Trunk, own_server
from workbook.recording.limits import ANSWER_LIMITS
from workbook.ros.domains import NoDomainFree, lease_in_private
from workbook.ros.environment import child_environment
from workbook.watching.observer import Observer
from workbook.watching.tier_self_test import try_out


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


@cache
def _exercise(stem: str) -> Exercise:
    return load_exercise(stem)


def serve(
    isolation: Isolation,
    ids: Ids | None = None,
    port: int | None = None,
    groups: Path | None = None,
    trunks: Sequence[Trunk] = (),
) -> None:
    """Answer jobs until standard input is closed. With "uid" the programs run under `ids`, which the caller leased.

    `port`: of a listener on this machine, for trying out the tier first. `groups`: the folder for memory cgroups, which
    the caller leased. `trunks`: two, from which the fork servers of a sandbox are forked, or none.
    """
    channel = _private_output()
    adopt_orphans()
    set_parent_death_signal(signal.SIGTERM)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, _end_on_sigterm)
    inbox = _Inbox()

    def send(message: dict[str, Any]) -> None:
        channel.write(json.dumps(message, allow_nan=False) + "\n")
        channel.flush()

    def report(judgement: Judgement) -> None:
        send({"final": False, "judgement": judgement_to_json(judgement)})

    servers = [*map(ForkServer, trunks)] or [ForkServer()]
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
            inbox.enough.clear()
            send(_follow(job, judge, report, inbox.enough.is_set))


def _follow(
    job: Mapping[str, Any], judge: Judge, report: Report, enough: Callable[[], bool]
) -> dict[str, Any]:
    """Judge one answer and sweep up behind it. Returns the last line on it: its judgement, or what went wrong.

    Raises ServerGone: then this slot is to be replaced, and the answer judged in another one.
    """
    try:
        judgement = judge.judge(
            _exercise(job["exercise"]),
            Answer(job["answer"]),
            thorough=job["thorough"],
            seed=job["seed"],
            report=report,
            enough=enough,
        )
        message = {"final": True, "judgement": judgement_to_json(judgement)}
    except ServerGone:
        raise
    except Exception as error:
        message = {"final": True, "error": f"{type(error).__name__}: {error}"}
    try:
        sweep_orphans()
    except StillThere as error:
        message = {"final": True, "error": str(error)}
    return message


def warm_up(isolation: Isolation, server: ForkServer) -> None:
    """Prepare to fork programs: in a sandbox from `server`, in other tiers from this process's own fork server.

    A sandbox has a network of its own, so its leases say nothing about this process.
    """
    if isolation == "sandbox":
        lease_in_private()
        server.start(sandbox_environment(child_environment(0, log_folder=Path(os.devnull))))
    else:
        own_server.keep()


def main() -> None:
    """Read the command line, then answer jobs until standard input is closed."""
    parser = argparse.ArgumentParser()
    parser.add_argument("tier", type=named_tier)
    parser.add_argument("--user", type=lambda text: Ids(int(text)))
    parser.add_argument("--groups", type=Path)
    parser.add_argument("--try", type=int, dest="port")
    asked = parser.parse_args()
    serve(asked.tier, asked.user, asked.port, asked.groups)


if __name__ == "__main__":
    main()
