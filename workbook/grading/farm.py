"""Judge answers on a farm (a dask.distributed cluster): find workers, hand out answers, and handle lost workers.

A worker is a dask process on one of the machines. It only starts slots, which are processes that judge answers (see
`workbook.grading.farm_worker`). We, not dask, choose the worker for each answer, and never hand out more answers than
the workers have threads. So when a worker is lost, we lose only a few answers, and we know which ones. We judge these
again on other workers. Each of them then gets a worker to itself, so that an answer that kills its worker doesn't
affect other answers.
"""

import json
import queue
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, Generic

from workbook.exercise.course import course_sha256
from workbook.exercise.definition import load_exercise, own_criteria
from workbook.exercise.judgement import Judgement
from workbook.exercise.serialization import judgement_from_afar
from workbook.grading import farm_worker
from workbook.grading.farm_connection import LOOK_EVERY_S, connect, in_words, reply_in, text_of
from workbook.grading.judges import Job, Key, NoJudges
from workbook.isolation.tiers import Isolation

INTRODUCTION_S = 60.0
PATIENCE_WITHOUT_WORKERS_S = 60.0
TRIES = 3
"""The number of times that an answer is sent to a worker before we give up.

The first time, other answers may run on the same worker. After that, the answer gets a worker to itself.
"""
_START_HERE = "Start it in the course's folder: .venv/bin/dask worker"


@dataclass(eq=False)
class _Machine:
    """A worker of the farm. `places`: the number of answers that it can judge at the same time."""

    address: str
    places: int
    host: str = ""
    process: str = ""
    ready: bool = False
    refused: bool = False
    alone: bool = False
    under_way: set[str] = field(default_factory=set)

    @property
    def free(self) -> int:
        return self.places - len(self.under_way) if self.ready and not self.alone else 0

    def __str__(self) -> str:
        return f"{self.host} ({self.address})" if self.host else self.address


@dataclass(eq=False)
class _Task(Generic[Key]):
    """A job, which is an answer to judge.

    `losses`: the number of times that it was sent to a worker and no judgment came back.
    """

    job: Job[Key]
    losses: int = 0


@dataclass(frozen=True)
class _Sent(Generic[Key]):
    task: _Task[Key]
    machine: _Machine
    future: Any


class Farm:
    """Judges on the workers that belong to the scheduler at `address` and have the same version of the course as we do.

    Implements `GradingBackend`. `say` is called with a sentence about each worker that isn't used or was lost. Use a
    Farm as a context manager. Raises NoJudges if no worker can judge.
    """

    def __init__(self, address: str, isolation: Isolation, say: Callable[[str], None]) -> None:
        self._address = address
        self._isolation = isolation
        self._say = say
        self._machines: dict[str, _Machine] = {}
        self._questions: dict[str, tuple[_Machine, Any]] = {}
        self._done: queue.SimpleQueue[str] = queue.SimpleQueue()
        self._mustered_at = -LOOK_EVERY_S
        self._seen_at = time.monotonic()
        self._refusals: list[str] = []
        self._course = course_sha256()
        self._client = connect(address)
        try:
            self._meet_everybody()
        except BaseException:
            self.close()
            raise

    @property
    def isolation(self) -> Isolation:
        """The isolation tier in which all workers run programs."""
        return self._isolation

    @property
    def machines(self) -> int:
        """The number of workers that can judge answers."""
        return sum(machine.ready for machine in self._machines.values())

    @property
    def places(self) -> int:
        """The number of answers that can be judged at the same time."""
        return sum(machine.places for machine in self._machines.values() if machine.ready)

    def close(self) -> None:
        """Disconnect from the scheduler."""
        self._client.close()

    def __enter__(self) -> "Farm":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    # --- who is there -------------------------------------------------------------------------------------------

    def _meet_everybody(self) -> None:
        deadline = time.monotonic() + INTRODUCTION_S
        self._muster()
        while self._questions and time.monotonic() < deadline:
            try:
                self._meet(self._done.get(timeout=LOOK_EVERY_S))
            except queue.Empty:
                self._muster()
        if self.machines:
            return
        if not self._refusals:
            raise NoJudges(
                f"the scheduler at {self._address} has no workers. Start one on each machine, in the course's folder "
                f"there: .venv/bin/dask worker {self._address} --nthreads 16"
            )
        raise NoJudges(f"no worker at {self._address} can judge: " + "; ".join(self._refusals))

    def _muster(self) -> list[_Machine]:
        """Fetch the list of workers from the scheduler, and ask new workers for their properties.

        Do nothing if the list is less than a second old. Return the workers that have disappeared since the last time.
        Raises NoJudges if the scheduler doesn't respond.
        """
        if time.monotonic() - self._mustered_at < LOOK_EVERY_S:
            return []
        try:
            if self._client.status != "running":
                raise OSError("the connection is lost")
            threads: dict[str, int] = self._client.nthreads()
        except Exception as error:
            raise NoJudges(
                f"the scheduler at {self._address} does not answer any more ({in_words(error)}). Finished "
                "judgments are kept: start the scheduler and the workers again, and run the same command"
            ) from error
        self._mustered_at = time.monotonic()
        gone = [machine for address, machine in self._machines.items() if address not in threads]
        for machine in gone:
            del self._machines[machine.address]
        for key, (machine, question) in list(self._questions.items()):
            if machine in gone:
                del self._questions[key]
                question.cancel()
                self.refuse(
                    machine,
                    f"it ended before it answered our first request. {_START_HERE} {self._address}",
                )
        for address, places in threads.items():
            if address not in self._machines:
                self._ask(_Machine(address, places))
        if self.machines or self._questions:
            self._seen_at = time.monotonic()
        return gone

    def _ask(self, machine: _Machine) -> None:
        self._machines[machine.address] = machine
        question = self._submit(
            machine,
            farm_worker.introduce,
            self._isolation,
            self._course,
            farm_worker.rclpy_version(),
            farm_worker.python_version(),
        )
        self._questions[question.key] = (machine, question)

    def _submit(self, machine: _Machine, work: Callable[..., str], *arguments: object) -> Any:
        future = self._client.submit(
            work, *arguments, workers=[machine.address], allow_other_workers=False, pure=False, retries=0
        )
        future.add_done_callback(lambda done: self._done.put(done.key))
        return future

    def _meet(self, key: str) -> bool:
        """Handle a reply if it's a new worker's first reply, which contains the worker's properties.

        Return whether it is.
        """
        if key not in self._questions:
            return False
        machine, question = self._questions.pop(key)
        if self._machines.get(machine.address) is not machine:
            return True
        try:
            told = json.loads(text_of(question))
            machine.host, machine.process, problem = told["host"], told["process"], told["problem"]
        except Exception as error:
            problem = f"it does not know this course ({in_words(error)}). {_START_HERE} {self._address}"
        if problem is None:
            machine.ready = True
        else:
            self.refuse(machine, problem)
        return True

    def refuse(self, machine: _Machine, why: str) -> None:
        """Stop using a worker for the rest of the run, and report the reason.

        Do nothing if it has already been refused.
        """
        if machine.refused:
            return
        machine.ready, machine.refused = False, True
        self._refusals.append(f"{machine}: {why}")
        self._say(f"{machine} is not used: {why}.")

    # --- who judges what ----------------------------------------------------------------------------------------

    def judge_all(
        self, jobs: Iterable[Job[Key]], *, soak: bool = True, stop: Callable[[], bool] = lambda: False
    ) -> Iterator[tuple[Job[Key], Judgement]]:
        """Judge many answers. See `GradingBackend`.

        Raises NoJudges if the scheduler is lost or if there has been no worker for a minute.
        """
        distribution = _Distribution(self, jobs, soak)
        try:
            while True:
                for machine in self._muster():
                    yield from distribution.give_up_on(machine)
                if not stop():
                    distribution.hand_out()
                if not distribution.is_under_way:
                    if stop() or not distribution.is_left:
                        return
                    self._expect_somebody()
                try:
                    key = self._done.get(timeout=LOOK_EVERY_S)
                except queue.Empty:
                    continue
                if not self._meet(key):
                    yield from distribution.settle(key)
        finally:
            distribution.cancel()

    def ready_machines(self) -> list["_Machine"]:
        """Return the workers that can receive answers now."""
        return [machine for machine in self._machines.values() if machine.ready]

    def send(self, job: Job[Key], soak: bool, machine: "_Machine") -> Any:
        """Send an answer to a worker. Return a future for the reply."""
        return self._submit(machine, farm_worker.judge, self._order(job, soak, machine))

    def _order(self, job: Job[Key], soak: bool, machine: _Machine) -> str:
        return farm_worker.FarmJob(
            exercise=job.stem,
            answer=job.answer.text,
            soak=soak,
            isolation=self._isolation,
            course=self._course,
            own_criteria=_text_of_file(own_criteria(job.stem)),
            process=machine.process,
            seed=job.seed,
        ).to_text()

    def announce_loss(self, machine: _Machine) -> None:
        """Report that a worker is gone and how many of its answers will be judged again on other workers."""
        if not machine.ready:
            return
        again = len(machine.under_way)
        what = "answer is" if again == 1 else f"{again} answers are"
        self._say(f"{machine} is gone." + (f" Its {what} judged again elsewhere." if again else ""))

    def _expect_somebody(self) -> None:
        """Raise NoJudges if there has been no worker for a minute."""
        if any(machine.ready for machine in self._machines.values()):
            return
        if time.monotonic() - self._seen_at > PATIENCE_WITHOUT_WORKERS_S:
            why = f" ({'; '.join(self._refusals)})" if self._refusals else ""
            raise NoJudges(
                f"no worker is left at {self._address}{why}. Finished judgments are kept: start workers, and run "
                "the same command again"
            )


class _Distribution(Generic[Key]):
    """Tracks the answers of one run: those that are waiting, those that workers have, and those to judge again alone.

    An answer is settled when its judgment has arrived or when it was lost too often.
    """

    def __init__(self, farm: Farm, jobs: Iterable[Job[Key]], soak: bool) -> None:
        self._farm = farm
        self._soak = soak
        self._waiting = deque(_Task(job) for job in jobs)
        self._suspects: deque[_Task[Key]] = deque()
        self._sent: dict[str, _Sent[Key]] = {}

    @property
    def is_under_way(self) -> bool:
        return bool(self._sent)

    @property
    def is_left(self) -> bool:
        """Whether answers are still waiting for a worker."""
        return bool(self._waiting or self._suspects)

    def hand_out(self) -> None:
        """Send waiting answers to free workers.

        A suspect, which is an answer that was lost before, gets a worker to itself.
        """
        ready = self._farm.ready_machines()
        while self._waiting and ready:
            machine = max(ready, key=lambda one: one.free)
            if machine.free <= 0:
                return
            self._send(self._waiting.popleft(), machine)
        for machine in ready:
            if self._suspects and not machine.under_way:
                self._send(self._suspects.popleft(), machine)

    def give_up_on(self, machine: _Machine) -> Iterator[tuple[Job[Key], Judgement]]:
        """Take back a lost worker's answers. Yield those that have been lost too often to be judged again."""
        self._farm.announce_loss(machine)
        for key in list(machine.under_way):
            self._sent[key].future.cancel()
            yield from self._lost(self._take_back(key), f"{machine} went away")

    def settle(self, key: str) -> Iterator[tuple[Job[Key], Judgement]]:
        """Handle a worker's reply about an answer. If the answer is now settled, yield it with its judgment.

        Yield nothing if the answer will be judged again.
        """
        if key not in self._sent:
            return
        machine, future = self._sent[key].machine, self._sent[key].future
        task = self._take_back(key)
        reply: dict[str, Any] = {}
        judgement, why = None, "the worker was started again"
        try:
            reply = reply_in(text_of(future))
            if "judgement" in reply:
                judgement = _checked(reply["judgement"], task.job)
            why = reply.get("fault") or why
        except Exception as error:
            reply, why = {}, in_words(error)
        if judgement is not None:
            yield task.job, judgement
        elif "refused" in reply:
            self._farm.refuse(machine, str(reply["refused"]))
            self._waiting.appendleft(task)
        else:
            yield from self._lost(task, f"{why} (on {machine})")

    def cancel(self) -> None:
        """Cancel the judging of all answers that were sent to workers."""
        for one in self._sent.values():
            one.machine.under_way.clear()
            one.machine.alone = False
            one.future.cancel()

    def _send(self, task: _Task[Key], machine: _Machine) -> None:
        future = self._farm.send(task.job, self._soak, machine)
        machine.under_way.add(future.key)
        machine.alone = task.losses > 0
        self._sent[future.key] = _Sent(task, machine, future)

    def _take_back(self, key: str) -> _Task[Key]:
        one = self._sent.pop(key)
        one.machine.under_way.discard(key)
        one.machine.alone = False
        return one.task

    def _lost(self, task: _Task[Key], why: str) -> Iterator[tuple[Job[Key], Judgement]]:
        task.losses += 1
        if task.losses < TRIES:
            self._suspects.append(task)
        else:
            yield task.job, _given_up(task.job, why)


def _given_up(job: Job[Key], why: str) -> Judgement:
    reason = f"not judged in {TRIES} tries, two of them with a worker to itself; the last time: {why}"
    return Judgement(job.stem, job.answer.sha256, "infra_error", reason, (), None)


@cache
def _judged_criteria(stem: str) -> dict[str, float]:
    return {one.id: one.points for one in load_exercise(stem).criteria}


def _checked(data: object, job: Job[Key]) -> Judgement:
    """Decode the judgment of this job's answer.

    Raises ValueError if the data is damaged, is about another answer, or was made with other criteria.
    """
    judgement = judgement_from_afar(data, job.stem, job.answer.sha256)
    if judgement.status == "graded":
        judged = {one.id: one.max_points for one in judgement.criteria}
        if judged != _judged_criteria(judgement.stem) or len(judged) != len(judgement.criteria):
            raise ValueError("the answer was judged by other criteria than this course's")
    return judgement


@cache
def _text_of_file(path: Path | None) -> str | None:
    return None if path is None else path.read_text(encoding="utf-8")
