"""What runs inside a worker of the farm: it starts slots, hands answers to them, and keeps them warm in between.

No answer runs in here. What comes in is an order, what goes out is a reply, both as JSON text. dask pickles that text,
and whatever an answer has touched is no more than characters in it.
"""

import hashlib
import json
import platform
import secrets
import threading
import time
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any, NamedTuple

from workbook.exercise.answers import Answer
from workbook.exercise.course import NoCourse, course_folder, course_sha256
from workbook.exercise.serialization import judgement_to_json
from workbook.grading.judges import Job
from workbook.grading.pool import Slot, judge_with_retry
from workbook.grading.tier_check import tier_problem
from workbook.isolation.tiers import Isolation
from workbook.recording.codec import decode, encode
from workbook.ros.scratch import scratch_folder

IDLE_S = 60.0
"""How long (s) a slot waits for the next answer before it is ended: about 100 MB of memory each."""
PROCESS = secrets.token_hex(8)
"""This very process: an order for another one is not followed, whatever address both have."""


@dataclass(frozen=True)
class FarmJob:
    """One answer to judge, as it is sent to a worker.

    `course`: hash of the sender's version of the course, which the worker must have, too. `own_criteria`: the text of
    an instructor's own criteria. `process`: the worker process that the job is meant for.
    """

    exercise: str
    answer: str
    thorough: bool
    isolation: Isolation
    course: str
    own_criteria: str | None
    process: str
    seed: int | None = None

    def to_text(self) -> str:
        """The job as JSON."""
        return json.dumps(encode(self))


def rclpy_version() -> str:
    """The version of the rclpy wheel; "system" where rclpy is not installed as a wheel."""
    try:
        return metadata.version("ros-jazzy-rclpy")
    except metadata.PackageNotFoundError:
        return "system"


def python_version() -> str:
    """Without the last number: 3.12."""
    return ".".join(platform.python_version_tuple()[:2])


def _course_now() -> str:
    try:
        return course_sha256()
    except (NoCourse, OSError) as error:
        return str(error)


_COURSE_LOADED = _course_now()


def course_problem(wanted: str) -> str | None:
    """Why answers cannot be judged here by the version of the course whose hash is `wanted`; None when they can."""
    now = _course_now()
    if now == wanted == _COURSE_LOADED:
        return None
    if now == wanted:
        return "the course has changed since this worker was started. Start the worker again"
    try:
        folder = course_folder()
    except NoCourse as error:
        return str(error)
    return (
        f"it has another version of the course in {folder} ({now[:10]}, and not {wanted[:10]}). Bring both to the same "
        "commit, without changes of your own, and start the worker again"
    )


def introduce(isolation: Isolation, course: str, rclpy: str, python: str) -> str:
    """Who this worker is, as JSON, and its `problem`: why it cannot judge as it is asked to; null if it can."""
    problem = course_problem(course)
    if problem is None and (rclpy_version(), python_version()) != (rclpy, python):
        problem = (
            f"it has rclpy {rclpy_version()} and Python {python_version()}, and not rclpy {rclpy} and Python {python}. "
            "Make its environment with `make env`, with the same Python"
        )
    if problem is None:
        closed = tier_problem(isolation)
        if closed is not None:
            problem = f"it cannot confine programs: {closed}"
    return json.dumps({"host": platform.node(), "process": PROCESS, "problem": problem})


def judge(text: str) -> str:
    """Judge the answer of a `FarmJob`, given as JSON. Returns the reply as JSON.

    The reply has one key: "judgement", "refused" (why no answer can be judged here any more), "fault" (why this one was
    not judged), or "elsewhere" (the job was meant for another process).
    """
    try:
        return json.dumps(_judge(decode(FarmJob, json.loads(text))), allow_nan=False)
    except Exception as error:  # whatever it is goes back as words: exceptions would be pickled
        return json.dumps({"fault": f"{type(error).__name__}: {error}"})


def _judge(order: FarmJob) -> Mapping[str, Any]:
    if order.process != PROCESS:
        return {"elsewhere": True}
    problem = course_problem(order.course)
    if problem is not None:
        return {"refused": problem}
    kind = Kind(order.isolation, _folder_of(order.exercise, order.own_criteria))
    job = Job(None, order.exercise, Answer(order.answer), order.seed)
    slot, judgement = judge_with_retry(
        _rack.take(kind), job, order.thorough, order.isolation, kind.own_criteria
    )
    if slot is None:
        return {"fault": judgement.reason}
    _rack.give(kind, slot)
    return {"judgement": judgement_to_json(judgement)}


_criteria_lock = threading.Lock()
_criteria: Path | None = None


def _folder_of(stem: str, text: str | None) -> Path | None:
    """A folder with an instructor's own criteria, as they came with the order."""
    global _criteria
    if text is None:
        return None
    with _criteria_lock:
        if _criteria is None:
            _criteria = scratch_folder("criteria")
        folder = _criteria / hashlib.sha256(text.encode()).hexdigest()[:16]
        folder.mkdir(exist_ok=True)
        file = folder / f"{stem}.py"
        if not file.exists():
            partial = file.with_suffix(".part")
            partial.write_text(text, encoding="utf-8")
            partial.replace(file)
    return folder


class Kind(NamedTuple):
    """What a slot must have in common with a job to judge it."""

    isolation: Isolation
    own_criteria: Path | None


@dataclass(frozen=True)
class _Waiting:
    kind: Kind
    slot: Slot
    since: float


class Rack:
    """Warm slots with nothing to do. One that waits longer than `idle_s` is ended."""

    def __init__(self, idle_s: float = IDLE_S) -> None:
        self._idle_s = idle_s
        self._slots: list[_Waiting] = []
        self._changed = threading.Condition()
        self._keeper: threading.Thread | None = None

    def take(self, kind: Kind) -> Slot | None:
        """A slot of this kind, if one is free."""
        with self._changed:
            for one in reversed(self._slots):
                if one.kind == kind:
                    self._slots.remove(one)
                    return one.slot
        return None

    def give(self, kind: Kind, slot: Slot) -> None:
        """Keep an idle slot for the next `take` of this kind."""
        with self._changed:
            self._slots.append(_Waiting(kind, slot, time.monotonic()))
            if self._keeper is None:
                self._keeper = threading.Thread(target=self._keep, name="rack of slots", daemon=True)
                self._keeper.start()
            self._changed.notify()

    def _keep(self) -> None:
        while True:
            self._next_overdue().slot.close()

    def _next_overdue(self) -> _Waiting:
        with self._changed:
            while True:
                if not self._slots:
                    self._changed.wait()
                    continue
                left = self._slots[0].since + self._idle_s - time.monotonic()
                if left <= 0:
                    return self._slots.pop(0)
                self._changed.wait(left)


_rack = Rack()
