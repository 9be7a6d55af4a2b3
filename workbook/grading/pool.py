"""Slots as their owner sees them: start one, give it an answer, get a judgement, replace it when it breaks."""

import atexit
import contextlib
import json
import os
import select
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from workbook.exercise.answers import Answer
from workbook.exercise.definition import OWN_CRITERIA, load_exercise
from workbook.exercise.judgement import Judgement, Report
from workbook.exercise.serialization import judgement_from_json
from workbook.grading.judges import Job, Key
from workbook.grading.slot_health import SlotHealth
from workbook.grading.turns import turn
from workbook.grading.warm_slots import ForkedSlot, SlotServer
from workbook.inside.orphans import StillThere
from workbook.isolation.memory_groups import lease_groups
from workbook.isolation.tiers import Isolation, lease_for, slot_command
from workbook.isolation.user_ids import NoIds
from workbook.programs.ending import kill_programs_of
from workbook.programs.warm_start import NoWarmStart
from workbook.ros.environment import child_environment

ANSWER_DEADLINE_S = 120.0
"""On a slot that always gets a processor. One that has to wait for it has longer; see `SlotHealth.slowed_by`."""
SLOT_MODULE = ("-m", "workbook.grading.slot")
KILLED_S = 30.0
"""So long a killed slot may take to go, with what its answer has left."""
TRIES = 2
STOPPED_JUDGE = "stopped_judge"
"""How the reason begins why an answer is ungradable that breaks the slots that judge it, where others do not."""
LOOK = "Look at it yourself: it is not run again as long as it stays the same, unless you ask with --retry-stopped"


class SlotBroken(RuntimeError):
    """The slot ended or did not answer in time. The message says which; the answer was not judged."""


class NotBegun(SlotBroken):
    """The slot could not begin: no answer is to blame. The message says why."""


def slot_environment(own_criteria: Path | None) -> dict[str, str]:
    """What a slot is started with."""
    # A slot makes its own log folder. One of ours would stay behind if we were killed.
    environ = child_environment(0, log_folder=Path(os.devnull))
    del environ["ROS_DOMAIN_ID"]
    for name in ("WORKBOOK_COURSE", OWN_CRITERIA, "PYTHONPATH"):
        if name in os.environ:
            environ[name] = os.environ[name]
    if own_criteria is not None:
        environ[OWN_CRITERIA] = str(own_criteria)
    environ.pop("ROS_LOG_DIR")
    return environ


class Slot:
    """A running slot process. Not for two threads at once.

    `isolation`: one of `workbook.isolation.tiers`. `own_criteria`: the folder with an instructor's own criteria, where
    it is not the one that this process was told of. `port`: of a listener on this machine; the slot then tries first
    whether the tier isolates (see `problem`). `server`: of the same tier and environment, to fork it from if it can.
    Raises SlotBroken when "uid" finds no free user id.
    """

    def __init__(
        self,
        isolation: Isolation = "limits",
        own_criteria: Path | None = None,
        *,
        port: int | None = None,
        server: SlotServer | None = None,
    ) -> None:
        try:
            self._ids = lease_for(isolation)
        except NoIds as error:
            raise SlotBroken(str(error)) from error
        self._groups = lease_groups()
        self.environ = slot_environment(own_criteria)
        self._process: subprocess.Popen[bytes] | ForkedSlot
        try:
            self._process, self._health = self._forked(server) or self._fresh(isolation, port)
        except BaseException:
            self._sweep()
            raise
        self._buffer = b""

    def _forked(self, server: SlotServer | None) -> tuple[ForkedSlot, SlotHealth] | None:
        """A process forked from the server; None if that does not work."""
        if server is None:
            return None
        try:
            process = server.fork(self._groups)
        except (NoWarmStart, OSError):
            return None
        return process, SlotHealth(process.pid)

    def _fresh(self, isolation: Isolation, port: int | None) -> tuple[subprocess.Popen[bytes], SlotHealth]:
        command = [sys.executable, *SLOT_MODULE, isolation]
        if self._ids is not None:
            command += ["--user", str(self._ids.user)]
        folder = None if self._groups is None else self._groups.path
        if folder is not None:
            command += ["--groups", str(folder)]
        if port is not None:
            command += ["--try", str(port)]
        process = subprocess.Popen(
            slot_command(isolation, command, folder),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env=self.environ,
            start_new_session=True,
        )
        return process, SlotHealth(process.pid, SLOT_MODULE)

    def problem(self, timeout_s: float) -> str | None:
        """Why its tier does not isolate here; None when it does. Only before the first job, of a slot that tries it.

        Raises SlotBroken when it does not get that far within `timeout_s` s.
        """
        self._health.begin()
        found = self._read_line(time.monotonic(), timeout_s)["problem"]
        return None if found is None else str(found)

    @property
    def is_running(self) -> bool:
        """Whether the slot's process is alive."""
        return self._process.poll() is None

    def _read_line(self, began: float, timeout_s: float) -> dict[str, Any]:
        """The next message. `timeout_s`: from the moment `began`, on a machine that is not busy."""
        assert self._process.stdout is not None
        descriptor = self._process.stdout.fileno()
        while b"\n" not in self._buffer:
            left = began + timeout_s - time.monotonic()
            if left <= 0:
                left = began + timeout_s * self._health.slowed_by() - time.monotonic()
            if left <= 0:
                raise SlotBroken("the slot did not answer in time")
            if not select.select([descriptor], [], [], min(left, 1.0))[0]:
                problem = self._health.problem()
                if problem is not None:
                    raise SlotBroken(problem)
                continue
            chunk = os.read(descriptor, 1 << 20)
            if not chunk:
                raise SlotBroken(f"the slot ended with code {self._process.wait()}")
            self._buffer += chunk
        line, _, self._buffer = self._buffer.partition(b"\n")
        message = json.loads(line)
        assert isinstance(message, dict)
        if "broken" in message:
            raise NotBegun(message["broken"])
        return message

    def judge(
        self,
        stem: str,
        answer: Answer,
        *,
        thorough: bool,
        seed: int | None = None,
        report: Report | None = None,
    ) -> Judgement:
        """Judge one answer; see `Judge.judge`. Raises SlotBroken; use a new slot then."""
        self._health.begin()
        began = time.monotonic()
        order = {"exercise": stem, "answer": answer.text, "thorough": thorough, "seed": seed}
        assert self._process.stdin is not None
        try:
            self._process.stdin.write((json.dumps(order) + "\n").encode())
            self._process.stdin.flush()
        except OSError as error:
            self._read_line(began, ANSWER_DEADLINE_S)  # it may have said why
            raise SlotBroken("the slot is gone") from error
        while True:
            message = self._read_line(began, ANSWER_DEADLINE_S)
            if "ready" in message:
                continue
            if "error" in message:
                return Judgement(stem, answer.sha256, "infra_error", message["error"], (), None)
            judgement = judgement_from_json(message["judgement"])
            if message["final"]:
                return judgement
            if report is not None:
                report(judgement)

    def enough(self) -> None:
        """Cut short the real seconds that a passing program is kept running for. May be called from any thread."""
        assert self._process.stdin is not None
        with contextlib.suppress(OSError, ValueError):
            self._process.stdin.write(b'{"enough": true}\n')
            self._process.stdin.flush()

    def close(self) -> None:
        """End the slot: it stops when its input closes; what does not stop within two seconds is killed."""
        if self._process.stdin is not None:
            try:
                self._process.stdin.close()
            except OSError:
                pass
        try:
            self._process.wait(2.0)
        except subprocess.TimeoutExpired:
            self.kill()
        self._sweep()
        if self._process.stdout is not None:
            self._process.stdout.close()

    def kill(self) -> None:
        """End the slot at once, and the program that it watches with all its children."""
        with contextlib.suppress(ProcessLookupError, PermissionError):
            os.killpg(self._process.pid, signal.SIGKILL)
        with contextlib.suppress(subprocess.TimeoutExpired):  # then its server is stuck
            self._process.wait(KILLED_S)
        kill_programs_of(self._process.pid)
        self._sweep()

    def _sweep(self) -> None:
        """Remove the memory cgroups of this slot, end what runs under its user id, and give the id back."""
        if self._groups is not None:
            self._groups.remove()
        if self._ids is not None:
            try:
                self._ids.sweep()
            except StillThere:  # then nobody else shall have this id while the grader runs
                return
            self._ids.release()
            self._ids = None

    def __enter__(self) -> "Slot":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


class _StandbySlots:
    """A slot that was started to try a tier, kept for the first answer that is judged in that tier."""

    def __init__(self) -> None:
        self._slots: dict[Isolation, Slot] = {}
        self._owner = os.getpid()
        atexit.register(self.close)

    def keep(self, isolation: Isolation, slot: Slot) -> None:
        """Keep a slot, in place of the one that was kept before."""
        before = self._slots.pop(isolation, None)
        if before is not None:
            before.close()
        self._slots[isolation] = slot

    def take(
        self, isolation: Isolation, own_criteria: Path | None = None, server: SlotServer | None = None
    ) -> Slot:
        """The slot that was kept, if it is as good as a new one, or a new one. See `Slot`."""
        slot = self._slots.pop(isolation, None)
        if slot is not None:
            if slot.is_running and slot.environ == slot_environment(own_criteria):
                return slot
            slot.close()
        return Slot(isolation, own_criteria, server=server)

    def close(self) -> None:
        """End those that nobody took."""
        while self._slots and self._owner == os.getpid():  # they are not those of a fork
            self._slots.popitem()[1].close()


standby = _StandbySlots()


def judge_with_retry(
    slot: Slot | None,
    job: Job[Key],
    thorough: bool,
    isolation: Isolation = "limits",
    own_criteria: Path | None = None,
    report: Report | None = None,
    server: SlotServer | None = None,
) -> tuple[Slot | None, Judgement]:
    """Judge a job, replacing a slot that breaks, at most twice. `server`: what new slots are forked from.

    If both slots break at this answer, and a new one judges a right answer, the answer is to blame: it is `ungradable`,
    for the reason `STOPPED_JUDGE`. Else the fault is ours: `infra_error` and no slot.
    """
    with turn(isolation):
        return _judge_with_retry(slot, job, thorough, isolation, own_criteria, report, server)


def _judge_with_retry(
    slot: Slot | None,
    job: Job[Key],
    thorough: bool,
    isolation: Isolation,
    own_criteria: Path | None,
    report: Report | None,
    server: SlotServer | None,
) -> tuple[Slot | None, Judgement]:
    reason = ""
    stopped = 0
    for _ in range(TRIES):
        at_work = False
        try:
            if slot is not None and not slot.is_running:
                slot.close()
                slot = None
            slot = slot or standby.take(isolation, own_criteria, server)
            at_work = True
            judgement = slot.judge(
                job.stem,
                job.answer,
                thorough=thorough,
                seed=job.seed,
                report=report,
            )
            return slot, judgement
        except Exception as error:  # whatever it is, the answer must not get lost
            reason = str(error) or type(error).__name__
            stopped += at_work and isinstance(error, SlotBroken) and not isinstance(error, NotBegun)
            if slot is not None:
                slot.kill()
            slot = None
    if stopped == TRIES:
        slot = _slot_that_judges(job.stem, isolation, own_criteria)
        if slot is not None:
            told = f"{STOPPED_JUDGE}: {reason}, {TRIES} times with this answer, and then judged a right one. {LOOK}"
            return slot, Judgement(job.stem, job.answer.sha256, "ungradable", told, (), None)
    reason += f", {TRIES} times with this answer. Run the command again; if it fails again, look at the answer yourself"
    return None, Judgement(job.stem, job.answer.sha256, "infra_error", reason, (), None)


def _slot_that_judges(stem: str, isolation: Isolation, own_criteria: Path | None) -> Slot | None:
    """A new slot that has just judged the reference answer of an exercise; None where that fails, or there is none."""
    slot: Slot | None = None
    try:
        right = load_exercise(stem).source.solution_code
        slot = Slot(isolation, own_criteria)
        if slot.judge(stem, Answer(right), thorough=False).status == "graded":
            return slot
    except Exception:  # whatever it is, nothing is proved against the answer then
        pass
    if slot is not None:
        slot.kill()
    return None
