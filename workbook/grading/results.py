"""`results.jsonl`: one line per judged answer, the one truth that every export is made from."""

import fcntl
import hashlib
import json
import os
import platform
from collections.abc import Iterator, Mapping, Sequence
from importlib import metadata
from pathlib import Path
from typing import Any, NamedTuple

import workbook
from workbook.exercise.judging import Judgement

RESULTS = "results.jsonl"
LOG_BYTES = 8_000

Result = dict[str, Any]


def versions(criteria_sha256: str) -> dict[str, str]:
    """What a result was made with."""
    try:
        rclpy_version = metadata.version("ros-jazzy-rclpy")
    except metadata.PackageNotFoundError:
        rclpy_version = "system"
    return {
        "workbook": workbook.__version__,
        "criteria": criteria_sha256,
        "rclpy": rclpy_version,
        "python": platform.python_version(),
    }


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


def _try(out: Path, judgement: Judgement, counts: bool) -> dict[str, Any]:
    recording = judgement.recording
    return {
        "counts": counts,
        "doubt": judgement.doubt,
        "status": judgement.status,
        "reason": judgement.reason,
        "score": judgement.score,
        "criteria": [result.to_json() for result in judgement.criteria],
        "recording": _recording_file(out, judgement),
        "clock": None if recording is None else recording.clock,
        "wall_s": None if recording is None else recording.wall_s,
    }


def graded_result(
    out: Path,
    judgement: Judgement,
    *,
    student: str,
    answer: str,
    submitted_at: str | None,
    attempt: int,
    isolation: str,
    criteria_sha256: str,
    max_score: float,
    tries: Sequence[Judgement] = (),
) -> Result:
    """The result of an answer that was run, with its recording stored under `out`.

    `tries`: all judgements of an answer that was tried more than once; `judgement` is the one that counts.
    """
    recording = judgement.recording
    process = None
    if recording is not None:
        process = {
            "exit": recording.process.exit,
            "signal": recording.process.signal,
            "limits_hit": list(recording.process.limits_hit),
            "log": recording.process.log[:LOG_BYTES],
        }
    return {
        "student": student,
        "answer": answer,
        "answer_sha256": judgement.answer_sha256,
        "submitted_at": submitted_at,
        "exercise": judgement.stem,
        "attempt": attempt,
        "status": judgement.status,
        "reason": judgement.reason,
        "score": judgement.score,
        "max_score": max_score,
        "criteria": [result.to_json() for result in judgement.criteria],
        "process": process,
        "recording": _recording_file(out, judgement),
        "clock": None if recording is None else recording.clock,
        "robot_s": None if recording is None else recording.robot_s,
        "wall_s": None if recording is None else recording.wall_s,
        "isolation": isolation,
        "versions": versions(criteria_sha256),
        "doubt": judgement.doubt,
        "tries": [_try(out, one, one is judgement) for one in tries] if len(tries) > 1 else [],
    }


def ungradable_result(
    *,
    student: str,
    answer: str,
    answer_sha256: str,
    submitted_at: str | None,
    exercise: str,
    attempt: int,
    reason: str,
    isolation: str,
    criteria_sha256: str,
    max_score: float,
) -> Result:
    """The result of an answer that could not be run. It has no score: that is not a zero."""
    return {
        "student": student,
        "answer": answer,
        "answer_sha256": answer_sha256,
        "submitted_at": submitted_at,
        "exercise": exercise,
        "attempt": attempt,
        "status": "ungradable",
        "reason": reason,
        "score": None,
        "max_score": max_score,
        "criteria": [],
        "process": None,
        "recording": None,
        "clock": None,
        "robot_s": None,
        "wall_s": None,
        "isolation": isolation,
        "versions": versions(criteria_sha256),
        "doubt": "",
        "tries": [],
    }


def tried_twice(result: Result) -> str:
    """What both tries of an answer gave, as a sentence; empty for an answer that was judged once."""
    tries = result.get("tries") or []
    if len(tries) < 2:
        return ""
    told = [_told(one) for one in tries]
    kept = " The better one counts." if told[0] != told[1] else ""
    doubt = tries[0]["doubt"]
    second = " So was the second." if tries[1]["doubt"] else ""
    return f"Tried twice: {told[0]}, then {told[1]}.{kept} The first try was inconclusive ({doubt}).{second}"


def tries_differ(result: Result) -> bool:
    """Whether an answer was tried twice and did not get the same both times."""
    return len({_told(one) for one in result.get("tries") or []}) > 1


def _told(one: Mapping[str, Any]) -> str:
    return "not judged" if one["score"] is None else f"{one['score']:g} points"


def read_results(path: Path) -> Iterator[Result]:
    """All complete lines of a results file. A torn line (a run was killed while writing) is left out."""
    if not path.exists():
        return
    with path.open("rb") as file:
        for line in file:
            if not line.endswith(b"\n"):
                return
            try:
                result = json.loads(line)
            except ValueError:
                continue
            if isinstance(result, dict) and "student" in result and "exercise" in result:
                yield result


def last_results(path: Path) -> dict[tuple[str, str], Result]:
    """The result that counts per (student, exercise): the last complete line."""
    return {(result["student"], result["exercise"]): result for result in read_results(path)}


class Done(NamedTuple):
    """What an earlier run has to say of one answer: enough to know whether it must be judged again."""

    status: str
    answer_sha256: str
    criteria_sha256: str
    attempt: int


def done_before(path: Path, exercise: str) -> dict[str, Done]:
    """By student, what is known of one exercise. Small: a large class fits many times into memory."""
    return {
        result["student"]: Done(
            result["status"],
            result["answer_sha256"],
            result["versions"]["criteria"],
            int(result["attempt"]),
        )
        for result in read_results(path)
        if result["exercise"] == exercise
    }


class FolderInUse(OSError):
    """Another grader writes to the same folder. The message says which, and what to do."""


class ResultsFile:
    """Appends results, each flushed to the disk before the next answer counts as done.

    One at a time: raises FolderInUse while another process has it open.
    """

    def __init__(self, path: Path) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        self._file = path.open("a", encoding="utf-8")
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            self._file.close()
            raise FolderInUse(
                f"another grader is writing to {path.parent}. Wait until it has finished, or name another folder "
                "with --out"
            ) from None
        except OSError:
            pass  # this file system knows no locks
        self._drop_torn_line(path)
        for half_written in (path.parent / "recordings").glob("*.part"):
            half_written.unlink(missing_ok=True)

    @staticmethod
    def _drop_torn_line(path: Path) -> None:
        if not path.exists():
            return
        raw = path.read_bytes()
        if raw and not raw.endswith(b"\n"):
            with path.open("r+b") as file:
                file.truncate(raw.rfind(b"\n") + 1)

    def append(self, result: Result) -> None:
        self._file.write(json.dumps(result, allow_nan=False, ensure_ascii=False) + "\n")
        self._file.flush()
        os.fsync(self._file.fileno())

    def close(self) -> None:
        self._file.close()
