"""Judge answers inside a farm's worker: start slots, send them answers, and keep them running in between.

A slot is a process that judges answers, so the worker process itself doesn't run any. The worker receives an order and
returns a reply, both as JSON strings. Dask pickles only these strings, so data from an answer is never unpickled as
objects.
"""

import hashlib
import json
import platform
import secrets
import threading
from collections.abc import Mapping
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

from workbook.exercise.answers import Answer
from workbook.exercise.course import NoCourse, course_folder, course_sha256
from workbook.exercise.serialization import judgement_to_json
from workbook.grading.judges import Job
from workbook.grading.slots.pool import Kind, SlotPool, judge_with_retry
from workbook.grading.tier_check import tier_problem
from workbook.isolation.tiers import Isolation
from workbook.recording.codec import decode, encode
from workbook.ros.scratch import scratch_folder

IDLE_S = 60.0
"""The time (s) for which an idle slot is kept for the next answer. Each slot uses about 100 MB of memory."""
PROCESS = secrets.token_hex(8)
"""Identifies this process, so that it can reject orders that were meant for an earlier process at the same address."""


@dataclass(frozen=True)
class FarmJob:
    """One answer to judge, as it's sent to a worker.

    `course`: the hash of the sender's course version, which the worker must have, too. `own_criteria`: the content of
    the instructor's own criteria file, or None. `process`: the worker process that the job is meant for (see
    `PROCESS`).
    """

    exercise: str
    answer: str
    soak: bool
    isolation: Isolation
    course: str
    own_criteria: str | None
    process: str
    seed: int | None = None

    def to_text(self) -> str:
        """Return the job as JSON."""
        return json.dumps(encode(self))


def rclpy_version() -> str:
    """Return the rclpy wheel's version, or "system" if rclpy isn't installed as a wheel."""
    try:
        return metadata.version("ros-jazzy-rclpy")
    except metadata.PackageNotFoundError:
        return "system"


def python_version() -> str:
    """Return the Python version without its patch number, such as 3.12."""
    return ".".join(platform.python_version_tuple()[:2])


def _course_now() -> str:
    try:
        return course_sha256()
    except (NoCourse, OSError) as error:
        return str(error)


_COURSE_LOADED = _course_now()


def course_problem(wanted: str) -> str | None:
    """Return why this worker can't judge with the course version whose hash is `wanted`.

    Return None if the worker can.
    """
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
        "commit, without local changes, and start the worker again"
    )


def introduce(isolation: Isolation, course: str, rclpy: str, python: str) -> str:
    """Return the worker's properties as JSON.

    `problem` is the reason why the worker can't judge with these settings, or null if it can.
    """
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
    """Judge the answer in a `FarmJob`, given as JSON. Return the reply as JSON.

    The reply has one of these keys. `judgement`: the judgment. `refused`: the reason why this worker can't judge any
    more answers. `fault`: the reason why it couldn't judge this answer. `elsewhere`: true, because the job was meant
    for another process.
    """
    try:
        return json.dumps(_judge(decode(FarmJob, json.loads(text))), allow_nan=False)
    except Exception as error:  # we return its message as a string, because dask would pickle an exception
        return json.dumps({"fault": f"{type(error).__name__}: {error}"})


def _judge(order: FarmJob) -> Mapping[str, Any]:
    if order.process != PROCESS:
        return {"elsewhere": True}
    problem = course_problem(order.course)
    if problem is not None:
        return {"refused": problem}
    kind = Kind(order.isolation, _folder_of(order.exercise, order.own_criteria))
    job = Job(None, order.exercise, Answer(order.answer), order.seed)
    _slots.fork_from_now_on(kind)
    slot, judgement = judge_with_retry(_slots, _slots.take_warm(kind), kind, job, soak=order.soak)
    if slot is None:
        return {"fault": judgement.reason}
    _slots.give(kind, slot)
    return {"judgement": judgement_to_json(judgement)}


_slots = SlotPool(IDLE_S)
_criteria_lock = threading.Lock()
_criteria: Path | None = None


def _folder_of(stem: str, text: str | None) -> Path | None:
    """Return a folder with a criteria file that contains `text`, or None if `text` is None."""
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
