"""Slots as their owner sees them: start one, give it an answer, get a judgement, replace it when it breaks."""

import atexit
import contextlib
import json
import os
import queue
import select
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Generic, Protocol, TypeVar

from workbook.exercise.answers import Answer
from workbook.exercise.definition import OWN_CRITERIA, load_exercise
from workbook.exercise.exchange import judgement_from_json
from workbook.exercise.judging import Judgement, Report
from workbook.observing.orphans import StillThere
from workbook.observing.process import kill_programs_of
from workbook.observing.sandbox import outer_command
from workbook.observing.tiers import Isolation as Isolation
from workbook.observing.typecheck import TypeCheckFailed, learn
from workbook.observing.uids import NoIds, lease_ids
from workbook.ros.environment import child_environment

ANSWER_DEADLINE_S = 120.0
TRIES = 2
Key = TypeVar("Key")


class SlotBroken(RuntimeError):
    """The slot died or did not answer in time. Says which; the answer was not judged."""


def _environment(own_criteria: Path | None) -> dict[str, str]:
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

    `isolation`: one of `workbook.observing.tiers`. `own_criteria`: the folder with an instructor's own criteria, where
    it is not the one that this process was told of. `port`: of a listener on this machine; the slot then tries first
    whether the tier isolates (see `problem`). Raises SlotBroken when "uid" finds no free user id.
    """

    def __init__(
        self, isolation: Isolation = "limits", own_criteria: Path | None = None, *, port: int | None = None
    ) -> None:
        command = [sys.executable, "-m", "workbook.grading.slot", isolation]
        try:
            self._ids = lease_ids() if isolation == "uid" else None
        except NoIds as error:
            raise SlotBroken(str(error)) from error
        if self._ids is not None:
            command += ["--user", str(self._ids.user)]
        if port is not None:
            command += ["--try", str(port)]
        self.environ = _environment(own_criteria)
        self._process = subprocess.Popen(
            outer_command(command) if isolation == "sandbox" else command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            env=self.environ,
            start_new_session=True,
        )
        self._buffer = b""

    def problem(self, timeout_s: float) -> str | None:
        """Why its tier does not isolate here; None when it does. Only before the first job, of a slot that tries it.

        Raises SlotBroken when it does not get that far within `timeout_s` s.
        """
        found = self._read_line(time.monotonic() + timeout_s)["problem"]
        return None if found is None else str(found)

    @property
    def is_running(self) -> bool:
        return self._process.poll() is None

    def _read_line(self, deadline: float) -> dict[str, Any]:
        assert self._process.stdout is not None
        descriptor = self._process.stdout.fileno()
        while b"\n" not in self._buffer:
            left = deadline - time.monotonic()
            if left <= 0:
                raise SlotBroken("the slot did not answer in time")
            if not select.select([descriptor], [], [], min(left, 1.0))[0]:
                continue
            chunk = os.read(descriptor, 1 << 20)
            if not chunk:
                raise SlotBroken(f"the slot ended with code {self._process.wait()}")
            self._buffer += chunk
        line, _, self._buffer = self._buffer.partition(b"\n")
        message = json.loads(line)
        assert isinstance(message, dict)
        return message

    def judge(self, stem: str, answer: Answer, *, thorough: bool, report: Report | None = None) -> Judgement:
        """Judge one answer. Raises SlotBroken; use a new slot then."""
        deadline = time.monotonic() + ANSWER_DEADLINE_S
        job = json.dumps({"exercise": stem, "answer": answer.text, "thorough": thorough}) + "\n"
        assert self._process.stdin is not None
        try:
            self._process.stdin.write(job.encode())
            self._process.stdin.flush()
        except OSError as error:
            raise SlotBroken("the slot is gone") from error
        while True:
            message = self._read_line(deadline)
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
        try:
            os.killpg(self._process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self._process.wait()
        kill_programs_of(self._process.pid)
        self._sweep()

    def _sweep(self) -> None:
        """End what runs under the user id of this slot, and give the id back."""
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


class _Spare:
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

    def take(self, isolation: Isolation, own_criteria: Path | None = None) -> Slot:
        """The slot that was kept, if it is as good as a new one, or a new one. See `Slot`."""
        slot = self._slots.pop(isolation, None)
        if slot is not None:
            if slot.is_running and slot.environ == _environment(own_criteria):
                return slot
            slot.close()
        return Slot(isolation, own_criteria)

    def close(self) -> None:
        """End those that nobody took."""
        while self._slots and self._owner == os.getpid():  # they are not those of a fork
            self._slots.popitem()[1].close()


spare = _Spare()


@dataclass(frozen=True)
class Job(Generic[Key]):
    """One answer to judge; `key` is handed back with the judgement."""

    key: Key
    stem: str
    answer: Answer


class NoJudges(RuntimeError):
    """Nobody is there to judge, or nobody any longer. The message says why and what to do."""


class Judges(Protocol):
    """Whoever judges many answers: the slots of this machine, or a farm."""

    @property
    def isolation(self) -> Isolation:
        """How programs are shut in there."""

    def judge_all(
        self, jobs: Iterable[Job[Key]], *, thorough: bool = True, stop: Callable[[], bool] = lambda: False
    ) -> Iterator[tuple[Job[Key], Judgement]]:
        """Judge many answers; yields each judgement as it is ready, each job once.

        `stop` is asked before each new answer, so that an interrupted run ends after those under way. Raises NoJudges.
        """


@dataclass(frozen=True)
class LocalSlots:
    """Judges on `slots` slots of this machine."""

    slots: int
    isolation: Isolation = "limits"

    def judge_all(
        self, jobs: Iterable[Job[Key]], *, thorough: bool = True, stop: Callable[[], bool] = lambda: False
    ) -> Iterator[tuple[Job[Key], Judgement]]:
        """See `Judges`."""
        return judge_all(jobs, self.slots, thorough=thorough, isolation=self.isolation, stop=stop)


def judge_with_retry(
    slot: Slot | None,
    job: Job[Key],
    thorough: bool,
    isolation: Isolation = "limits",
    own_criteria: Path | None = None,
) -> tuple[Slot | None, Judgement]:
    """Judge a job, replacing a slot that breaks, at most twice; then the fault is ours: `infra_error` and no slot."""
    reason = ""
    for _ in range(TRIES):
        try:
            if slot is not None and not slot.is_running:
                slot.close()
                slot = None
            slot = slot or spare.take(isolation, own_criteria)
            return slot, slot.judge(job.stem, job.answer, thorough=thorough)
        except Exception as error:  # whatever it is, the answer must not get lost
            reason = str(error) or type(error).__name__
            if slot is not None:
                slot.kill()
            slot = None
    reason += f", {TRIES} times with this answer. Run the command again; if it stays so, look at this answer yourself"
    return None, Judgement(job.stem, job.answer.sha256, "infra_error", reason, (), None)


def _is_type_checked(stem: str) -> bool:
    try:
        return load_exercise(stem).source.kind == "static"
    except Exception:  # what is wrong with it, its judgements tell
        return False


def judge_all(
    jobs: Iterable[Job[Key]],
    slots: int,
    *,
    thorough: bool = True,
    isolation: Isolation = "limits",
    stop: Callable[[], bool] = lambda: False,
) -> Iterator[tuple[Job[Key], Judgement]]:
    """Judge many answers on `slots` slots; yields each judgement as it is ready.

    `stop` is asked before each new answer, so that an interrupted run ends after those under way.
    """
    waiting: queue.SimpleQueue[Job[Key]] = queue.SimpleQueue()
    total = 0
    stems = set()
    for job in jobs:
        waiting.put(job)
        stems.add(job.stem)
        total += 1
    if any(_is_type_checked(stem) for stem in stems):
        with contextlib.suppress(TypeCheckFailed):  # those who judge will say it
            learn()
    done: queue.SimpleQueue[tuple[Job[Key], Judgement] | None] = queue.SimpleQueue()

    def work() -> None:
        slot: Slot | None = None
        try:
            while not stop():
                try:
                    job = waiting.get_nowait()
                except queue.Empty:
                    break
                slot, judgement = judge_with_retry(slot, job, thorough, isolation)
                done.put((job, judgement))
        finally:
            if slot is not None:
                slot.close()
            done.put(None)

    threads = [threading.Thread(target=work, name=f"slot {n}") for n in range(max(1, min(slots, total)))]
    for thread in threads:
        thread.start()
    running = len(threads)
    try:
        while running:
            item = done.get()
            if item is None:
                running -= 1
            else:
                yield item
    finally:
        while not waiting.empty():
            waiting.get_nowait()
        for thread in threads:
            thread.join()
