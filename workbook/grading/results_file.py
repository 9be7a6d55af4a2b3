"""Read and write `results.jsonl`, which has one line per attempt. For each student and exercise, the last line counts.

Each line is appended and flushed as soon as its attempt finishes.
"""

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
    """A line of the file that isn't a valid result. `number`: the line number, starting at 1."""

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
    """Ignore an invalid line, because another pass over the file reports it."""


def line_of(result: Result) -> str:
    """Return a result as a line of the file. Raises ValueError if JSON can't represent a value in it."""
    return json.dumps(encode(result), allow_nan=False, ensure_ascii=False) + "\n"


def result_of(line: str | bytes) -> Result:
    """Parse a line that `line_of` returned. Raises ValueError if the line is invalid."""
    return decode(Result, json.loads(line))


def read_results(path: Path, tell_broken: TellBroken = tell_nobody) -> Iterator[Result]:
    """Yield all results in a file, or none if the file doesn't exist. Call `tell_broken` for each invalid line.

    Skip an incomplete last line, which remains when a run is killed while it's writing.
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
    """Return the current result for each student and exercise, which is their last complete line."""
    return {result.key: result for result in read_results(path, tell_broken)}


class Done(NamedTuple):
    """The parts of an earlier result from which we decide whether an answer must be judged again."""

    status: str
    answer_sha256: str
    criteria_sha256: str
    attempt: int
    reason: str | None = None


def done_before(path: Path, exercise: str) -> dict[str, Done]:
    """Return the earlier results of one exercise, keyed by student.

    Only parts of the results are returned, so that even a large class's results fit into memory.
    """
    return {
        result.student: Done(
            result.status, result.answer_sha256, result.versions.criteria, result.attempt, result.reason
        )
        for result in read_results(path)
        if result.exercise == exercise
    }


class FolderInUse(OSError):
    """Raised when another run is writing to the same folder. The message names the folder and the next step."""


class ResultsFile:
    """Appends results to the file. Each result is flushed to disk before its answer counts as done.

    Only one process may have the file open. In any other process, opening it raises FolderInUse.
    """

    def __init__(self, path: Path) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        self._file = path.open("a", encoding="utf-8")
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            self._file.close()
            raise FolderInUse(
                f"another `workbook grade` is writing to {path.parent}. Wait until it has finished, or "
                "name another folder with --out"
            ) from None
        except OSError:
            pass  # this file system doesn't support locks
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
        """Write one result, and return when it's on disk. On failure, raises an OSError that names the file."""
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
