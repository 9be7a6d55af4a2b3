"""Judging on the machines of a dask.distributed cluster: who is there, who gets which answer, and who is lost.

The workers only start slots (`workbook.grading.farm_worker`). We choose the worker for each answer and never hand out
more answers than there are threads, so that a worker that dies takes few answers with it, and we know which. Those are
judged again elsewhere, each with a worker to itself: whoever takes that one down, too, harms nobody else.
"""

import asyncio
import json
import logging
import queue
import re
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any, Generic

from workbook.exercise.course import course_sha256
from workbook.exercise.definition import load_exercise, own_criteria
from workbook.exercise.exchange import judgement_from_afar, no_constant
from workbook.exercise.judging import Judgement
from workbook.grading import farm_worker
from workbook.grading.pool import Isolation, Job, Key, NoJudges

CONNECT_S = 10.0
INTRODUCTION_S = 60.0
MUSTER_EVERY_S = 1.0
PATIENCE_WITHOUT_WORKERS_S = 60.0
FETCH_S = 30.0
TRIES = 3
"""How often an answer is judged when the worker dies meanwhile: once, and twice more alone."""
LARGEST_REPLY = 300_000_000
_START_HERE = "Start it in the course's folder: .venv/bin/dask worker"
_ADDRESS = re.compile(r"(tcp|tls)://(\[[0-9A-Fa-f:.]+\]|[\w.-]+):\d{1,5}")


@dataclass(eq=False)
class _Machine:
    """A worker, and how many answers it takes at once."""

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
    """A job, and how often it was lost."""

    job: Job[Key]
    losses: int = 0


@dataclass(frozen=True)
class _Sent(Generic[Key]):
    task: _Task[Key]
    machine: _Machine
    future: Any


class Farm:
    """Judges on every worker of the scheduler at `address` that has this version of the course. See `Judges`.

    `say` is told, a sentence each, which machines are not used, and which are lost. Use as a context manager. Raises
    NoJudges.
    """

    def __init__(self, address: str, isolation: Isolation, say: Callable[[str], None]) -> None:
        self._address = address
        self._isolation = isolation
        self._say = say
        self._machines: dict[str, _Machine] = {}
        self._questions: dict[str, tuple[_Machine, Any]] = {}
        self._done: queue.SimpleQueue[str] = queue.SimpleQueue()
        self._mustered_at = -MUSTER_EVERY_S
        self._seen_at = time.monotonic()
        self._refusals: list[str] = []
        self._course = course_sha256()
        self._client = _connect(address)
        try:
            self._meet_everybody()
        except BaseException:
            self.close()
            raise

    @property
    def isolation(self) -> Isolation:
        return self._isolation

    @property
    def machines(self) -> int:
        """Workers that judge."""
        return sum(machine.ready for machine in self._machines.values())

    @property
    def places(self) -> int:
        """Answers that are judged at once."""
        return sum(machine.places for machine in self._machines.values() if machine.ready)

    def close(self) -> None:
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
                self._meet(self._done.get(timeout=MUSTER_EVERY_S))
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
        """Ask the scheduler who is there, at most once a second. New workers are asked who they are.

        Returns those that are gone. Raises NoJudges when the scheduler does not answer.
        """
        if time.monotonic() - self._mustered_at < MUSTER_EVERY_S:
            return []
        try:
            if self._client.status != "running":
                raise OSError("the connection is lost")
            threads: dict[str, int] = self._client.nthreads()
        except Exception as error:
            raise NoJudges(
                f"the scheduler at {self._address} does not answer any more ({_words(error)}). What was judged is "
                "kept: start the scheduler and the workers again, and run the same command"
            ) from error
        self._mustered_at = time.monotonic()
        gone = [machine for address, machine in self._machines.items() if address not in threads]
        for machine in gone:
            del self._machines[machine.address]
        for key, (machine, question) in list(self._questions.items()):
            if machine in gone:
                del self._questions[key]
                question.cancel()
                self._refuse(machine, f"it ended when it was asked who it is. {_START_HERE} {self._address}")
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
        """Take note of who a worker is, if that is what `key` is about. Returns whether it was."""
        if key not in self._questions:
            return False
        machine, question = self._questions.pop(key)
        if self._machines.get(machine.address) is not machine:
            return True
        try:
            told = json.loads(_text_of(question))
            machine.host, machine.process, problem = told["host"], told["process"], told["problem"]
        except Exception as error:
            problem = f"it does not know this course ({_words(error)}). {_START_HERE} {self._address}"
        if problem is None:
            machine.ready = True
        else:
            self._refuse(machine, problem)
        return True

    def _refuse(self, machine: _Machine, why: str) -> None:
        if machine.refused:
            return
        machine.ready, machine.refused = False, True
        self._refusals.append(f"{machine}: {why}")
        self._say(f"{machine} is not used: {why}.")

    # --- who judges what ----------------------------------------------------------------------------------------

    def judge_all(
        self, jobs: Iterable[Job[Key]], *, thorough: bool = True, stop: Callable[[], bool] = lambda: False
    ) -> Iterator[tuple[Job[Key], Judgement]]:
        """See `Judges`. Raises NoJudges when the scheduler is lost, or no worker is left for a minute."""
        waiting = deque(_Task(job) for job in jobs)
        suspects: deque[_Task[Key]] = deque()
        sent: dict[str, _Sent[Key]] = {}

        def send(task: _Task[Key], machine: _Machine) -> None:
            future = self._submit(machine, farm_worker.judge, self._order(task.job, thorough, machine))
            machine.under_way.add(future.key)
            machine.alone = task.losses > 0
            sent[future.key] = _Sent(task, machine, future)

        def hand_out() -> None:
            ready = [machine for machine in self._machines.values() if machine.ready]
            while waiting and ready:
                machine = max(ready, key=lambda one: one.free)
                if machine.free <= 0:
                    return
                send(waiting.popleft(), machine)
            for machine in ready:
                if suspects and not machine.under_way:
                    send(suspects.popleft(), machine)

        def take_back(key: str) -> _Task[Key]:
            one = sent.pop(key)
            one.machine.under_way.discard(key)
            one.machine.alone = False
            return one.task

        def lost(task: _Task[Key], why: str) -> tuple[Job[Key], Judgement] | None:
            task.losses += 1
            if task.losses < TRIES:
                suspects.append(task)
                return None
            return task.job, _given_up(task.job, why)

        try:
            while True:
                for machine in self._muster():
                    self._announce_loss(machine)
                    for key in list(machine.under_way):
                        sent[key].future.cancel()
                        if (settled := lost(take_back(key), f"{machine} went away")) is not None:
                            yield settled
                if not stop():
                    hand_out()
                if not sent:
                    if stop() or not (waiting or suspects):
                        return
                    self._expect_somebody()
                try:
                    key = self._done.get(timeout=MUSTER_EVERY_S)
                except queue.Empty:
                    continue
                if self._meet(key) or key not in sent:
                    continue
                machine, future = sent[key].machine, sent[key].future
                task = take_back(key)
                try:
                    reply = _reply(_text_of(future))
                    if "judgement" in reply:
                        judgement = judgement_from_afar(
                            reply["judgement"], task.job.stem, task.job.answer.sha256
                        )
                        _check_criteria(judgement)
                        yield task.job, judgement
                        continue
                    why = f"{reply.get('fault') or 'the worker was started again'} (on {machine})"
                except Exception as error:
                    why = f"{_words(error)} (on {machine})"
                    reply = {}
                if "refused" in reply:
                    self._refuse(machine, str(reply["refused"]))
                    waiting.appendleft(task)
                elif (settled := lost(task, why)) is not None:
                    yield settled
        finally:
            for one in sent.values():
                one.machine.under_way.clear()
                one.machine.alone = False
                one.future.cancel()

    def _order(self, job: Job[Key], thorough: bool, machine: _Machine) -> str:
        return farm_worker.Order(
            exercise=job.stem,
            answer=job.answer.text,
            thorough=thorough,
            isolation=self._isolation,
            course=self._course,
            own_criteria=_text_of_file(own_criteria(job.stem)),
            process=machine.process,
        ).to_text()

    def _announce_loss(self, machine: _Machine) -> None:
        if not machine.ready:
            return
        again = len(machine.under_way)
        what = "answer is" if again == 1 else f"{again} answers are"
        self._say(f"{machine} is gone." + (f" Its {what} judged again elsewhere." if again else ""))

    def _expect_somebody(self) -> None:
        """Raises NoJudges when there has been no worker for a minute."""
        if any(machine.ready for machine in self._machines.values()):
            return
        if time.monotonic() - self._seen_at > PATIENCE_WITHOUT_WORKERS_S:
            why = f" ({'; '.join(self._refusals)})" if self._refusals else ""
            raise NoJudges(
                f"no worker is left at {self._address}{why}. What was judged is kept: start workers, and run the same "
                "command again"
            )


def check_address(address: str) -> None:
    """Raises NoJudges for what is no address of a scheduler."""
    if not _ADDRESS.fullmatch(address):
        raise NoJudges(f"--farm {address}: write it as tcp://host:8786, as the scheduler prints it")


def _connect(address: str) -> Any:
    """A client of the scheduler. Raises NoJudges."""
    try:
        from distributed import Client, Security
    except ImportError as error:
        raise NoJudges(
            f"--farm needs the package dask.distributed ({error}). Install it here and on the machines of the farm: "
            "make env EXTRAS=farm"
        ) from error
    for name in [*logging.root.manager.loggerDict]:
        if name.split(".")[0] in ("distributed", "tornado"):  # for developers; we say ourselves what matters
            logging.getLogger(name).setLevel(logging.CRITICAL + 1)
    try:
        security = Security()
        if address.startswith("tls:") and security.get_connection_args("client").get("ssl_context") is None:
            raise NoJudges("--farm tls://... needs certificates: see 'A farm' in environment.md")
        client = Client(
            address,
            security=security,
            timeout=CONNECT_S,
            name="workbook-grade",
            set_as_default=False,
            direct_to_workers=False,
        )
        client.loop.asyncio_loop.set_exception_handler(quiet_about_lost_waits)
        return client
    except NoJudges:
        raise
    except Exception as error:
        raise NoJudges(
            f"no scheduler answers at {address} within {CONNECT_S:.0f} s ({_words(error)}). Start one in the course's "
            "folder, .venv/bin/dask scheduler, and look at the firewall between you and it"
        ) from error


def quiet_about_lost_waits(loop: asyncio.AbstractEventLoop, context: dict[str, Any]) -> None:
    """Handler of an event loop that says nothing of waits for replies that went away, and passes on all else.

    When the worker that holds a reply is lost while the reply is fetched, distributed waits for it anew. We give up and
    cancel the reply; that wait then ends with AllExit, and nobody is left to receive it.
    """
    if type(context.get("exception")).__name__ != "AllExit":
        loop.default_exception_handler(context)


def _fetch(future: Any) -> object:
    """The reply of work that is finished. Raises RuntimeError as soon as its worker is seen to be lost."""

    async def fetched() -> object:
        return await future.client.gather(future, asynchronous=True)

    deadline = time.monotonic() + FETCH_S
    reply = asyncio.run_coroutine_threadsafe(fetched(), future.client.loop.asyncio_loop)
    while True:
        try:
            return reply.result(timeout=MUSTER_EVERY_S)
        except TimeoutError:
            if future.status != "finished" or time.monotonic() > deadline:
                reply.cancel()
                raise RuntimeError("the worker was lost before it could hand over the judgement") from None


def _text_of(future: Any) -> str:
    """What a worker replied. Raises RuntimeError when it did not."""
    if future.status != "finished":
        error = future.exception(timeout=FETCH_S) if future.status == "error" else None
        raise RuntimeError(_words(error) if error is not None else f"the work was {future.status}")
    text = _fetch(future)
    if not isinstance(text, str) or len(text) > LARGEST_REPLY:
        raise RuntimeError("the reply is not text, or far too much of it")
    return text


def _reply(text: str) -> dict[str, Any]:
    """Raises ValueError."""
    reply = json.loads(text, parse_constant=no_constant)
    if not isinstance(reply, dict) or not reply.keys() & {"judgement", "refused", "fault", "elsewhere"}:
        raise ValueError("the reply is damaged")
    return reply


def _given_up(job: Job[Key], why: str) -> Judgement:
    reason = f"not judged in {TRIES} tries, two of them with a worker to itself; the last time: {why}"
    return Judgement(job.stem, job.answer.sha256, "infra_error", reason, (), None)


@cache
def _judged_criteria(stem: str) -> dict[str, float]:
    return {one.id: one.points for one in load_exercise(stem).criteria}


def _check_criteria(judgement: Judgement) -> None:
    """Raises ValueError when a graded answer was not judged by exactly the criteria that are known here."""
    if judgement.status == "graded":
        judged = {one.id: one.max_points for one in judgement.criteria}
        if judged != _judged_criteria(judgement.stem) or len(judged) != len(judgement.criteria):
            raise ValueError("the answer was judged by other criteria than those of this course")


@cache
def _text_of_file(path: Path | None) -> str | None:
    return None if path is None else path.read_text(encoding="utf-8")


def _words(error: BaseException) -> str:
    """The first line of an error, or its name, for people."""
    first = "".join(one for one in str(error).strip().split("\n")[0][:200] if one.isprintable())
    return first or type(error).__name__
