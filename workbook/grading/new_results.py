"""Build a result from an answer's judgments, or from the reason why the answer couldn't be judged."""

import hashlib
import json
import os
import platform
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path

import workbook
from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import Judgement
from workbook.exercise.retries import what_counts
from workbook.grading.results import ProcessSummary, Result, Try, Versions, criterion_line

LOG_LENGTH = 8_000
"""The maximum length of a program's log in a result, in characters. The recording contains the complete log."""


@dataclass(frozen=True)
class Submission:
    """One student's hand-in, as a result describes it. `answer_sha256` is empty if the file couldn't be read.

    `note`: a sentence about other code in the notebook that the student may have meant to hand in.
    """

    student: str
    answer: str
    answer_sha256: str
    submitted_at: str | None = None
    attempt: int = 1
    note: str = ""


@dataclass(frozen=True)
class GradedBy:
    """The data that all results of a run have in common. `out`: the folder under which recordings are stored."""

    exercise: Exercise
    isolation: str
    out: Path


def versions(criteria_sha256: str) -> Versions:
    """Return the versions that are in use now, for a new result."""
    try:
        rclpy_version = metadata.version("ros-jazzy-rclpy")
    except metadata.PackageNotFoundError:
        rclpy_version = "system"
    return Versions(workbook.__version__, criteria_sha256, rclpy_version, platform.python_version())


def graded_result(submission: Submission, tries: Sequence[Judgement], by: GradedBy) -> Result:
    """Store an answer's recordings, and return its result.

    `tries`: the judgments of all tries, in order.
    """
    found = what_counts(tries)
    judgement = found.judgement
    recording = judgement.recording
    process = None
    if recording is not None:
        ended = recording.process
        process = ProcessSummary(
            ended.exit,
            ended.signal,
            tuple(ended.limits_hit),
            ended.log[:LOG_LENGTH],
            unfiltered=ended.unfiltered,
        )
    return Result(
        student=submission.student,
        answer=submission.answer,
        answer_sha256=judgement.answer_sha256,
        submitted_at=submission.submitted_at,
        exercise=judgement.stem,
        attempt=submission.attempt,
        status=judgement.status,
        reason=judgement.reason or submission.note or None,
        score=judgement.score,
        max_score=by.exercise.max_points,
        criteria=tuple(map(criterion_line, judgement.criteria)),
        process=process,
        recording=_recording_file(by.out, judgement),
        clock=None if recording is None else recording.clock,
        watched_s=None if recording is None else recording.watched_s,
        wall_s=None if recording is None else recording.wall_s,
        isolation=by.isolation,
        versions=versions(by.exercise.criteria_sha256),
        inconclusive_reason=judgement.inconclusive_reason,
        tries=tuple(_try(by.out, one, number == found.number) for number, one in enumerate(tries))
        if len(tries) > 1
        else (),
        why_this_try=found.why,
    )


def ungradable_result(submission: Submission, reason: str, by: GradedBy) -> Result:
    """Return the result of an answer that couldn't be run. Its score is None, not zero."""
    return Result(
        student=submission.student,
        answer=submission.answer,
        answer_sha256=submission.answer_sha256,
        submitted_at=submission.submitted_at,
        exercise=by.exercise.stem,
        attempt=submission.attempt,
        status="ungradable",
        reason=reason,
        score=None,
        max_score=by.exercise.max_points,
        criteria=(),
        process=None,
        recording=None,
        clock=None,
        watched_s=None,
        wall_s=None,
        isolation=by.isolation,
        versions=versions(by.exercise.criteria_sha256),
    )


def _try(out: Path, judgement: Judgement, counts: bool) -> Try:
    recording = judgement.recording
    return Try(
        counts=counts,
        inconclusive_reason=judgement.inconclusive_reason,
        end_only=judgement.end_only,
        status=judgement.status,
        reason=judgement.reason,
        score=judgement.score,
        criteria=tuple(map(criterion_line, judgement.criteria)),
        recording=_recording_file(out, judgement),
        clock=None if recording is None else recording.clock,
        wall_s=None if recording is None else recording.wall_s,
    )


def _recording_file(out: Path, judgement: Judgement) -> str | None:
    if judgement.recording is None:
        return None
    text = json.dumps(judgement.recording.to_json(), allow_nan=False, separators=(",", ":"))
    name = f"recordings/{hashlib.sha256(text.encode()).hexdigest()}.json"
    path = out / name
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_suffix(f".{os.getpid()}.part")
    partial.write_text(text)
    partial.replace(path)
    return name
