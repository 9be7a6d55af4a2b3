"""`results.jsonl`: one line per attempt, appended and flushed as each finishes; the last line of each answer counts."""

import fcntl
import json
import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from workbook.grading.files import naming
from workbook.grading.results import Result, StudentAndExercise
from workbook.recording.codec import decode, encode

RESULTS = "results.jsonl"


@dataclass(frozen=True)
class BrokenLine:
    """A line of the file that is not a result. `number` counts from 1."""

    path: Path
    number: int
    problem: str

    def __str__(self) -> str:
        return (
            f"{self.path}, line {self.number}, holds no result and does not count ({self.problem}): "
            "restore it, or delete it"
        )


TellBroken = Callable[[BrokenLine], None]


def tell_nobody(broken: BrokenLine) -> None:
    """Ignore a broken line, for files that are read a second time, when it is reported."""


def line_of(result: Result) -> str:
    """A result as a line of the file. Raises ValueError for what JSON cannot hold."""
    return json.dumps(encode(result), allow_nan=False, ensure_ascii=False) + "\n"


def result_of(line: str | bytes) -> Result:
    """The reverse of `line_of`. Raises ValueError."""
    return decode(Result, json.loads(line))


def read_results(path: Path, tell_broken: TellBroken = tell_nobody) -> Iterator[Result]:
    """All results of a file, which may be missing; `tell_broken` is told of each line that holds none.

    A torn last line (a run was killed while writing) is left out.
    """
    if not path.exists():
        return
    with path.open("rb") as file:
        for number, line in enumerate(file, start=1):
            if not line.endswith(b"\n"):
                return
            try:
                result = result_of(line)
            except json.JSONDecodeError as error:
                tell_broken(BrokenLine(path, number, f"it is not JSON: {error.msg}, column {error.colno}"))
            except (ValueError, RecursionError) as error:
                tell_broken(BrokenLine(path, number, str(error)))
            else:
                yield result


def last_results(path: Path, tell_broken: TellBroken = tell_nobody) -> dict[StudentAndExercise, Result]:
    """The result that counts per (student, exercise): the last complete line."""
    return {result.key: result for result in read_results(path, tell_broken)}


class Done(NamedTuple):
    """What an earlier run has to say of one answer: enough to know whether it must be judged again."""

    status: str
    answer_sha256: str
    criteria_sha256: str
    attempt: int
    reason: str | None = None


def done_before(path: Path, exercise: str) -> dict[str, Done]:
    """By student, what is known of one exercise. Small: a large class fits many times into memory."""
    return {
        result.student: Done(
            result.status, result.answer_sha256, result.versions.criteria, result.attempt, result.reason
        )
        for result in read_results(path)
        if result.exercise == exercise
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
        """Write one result, and return when it is on the disk. Raises OSError, which names the file."""
        with naming(Path(self._file.name)):
            self._file.write(line_of(result))
            self._file.flush()
            os.fsync(self._file.fileno())

    def close(self) -> None:
        """Close the file, so that another process can open it."""
        self._file.close()

    def __enter__(self) -> "ResultsFile":
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
