"""Find and explain the error in a program's log, and separate rclpy's own shutdown errors from the program's faults."""

import re
from dataclasses import dataclass

from workbook.criteria.verdict import Verdict, failed
from workbook.criteria.vocabulary.error_table import (
    KNOWN_ERRORS,
    OVERTAKEN,
    SPIN_OVERTAKEN,
    TAKE_OVERTAKEN,
    UNKNOWN_ERROR,
)
from workbook.criteria.vocabulary.field_values import unknown_field, value_that_misfits
from workbook.criteria.vocabulary.foreign_names import foreign_name
from workbook.criteria.vocabulary.missing_names import missing_name
from workbook.criteria.vocabulary.names_elsewhere import name_elsewhere
from workbook.criteria.vocabulary.tracebacks import TRACEBACK, chains_in, is_of, main_one
from workbook.recording.recording import Recording


@dataclass(frozen=True)
class ProgramError:
    """An error that made a program exit or crippled it, with an explanation.

    `error`: the traceback's last line. `line`: the line number in the student's file, or None. `cause`: the cause id.
    `because` and `try_this`: the explanation.
    """

    error: str
    line: int | None
    cause: str
    because: str
    try_this: str

    @property
    def where(self) -> str:
        """The line number as a prefix for a message, such as "line 12: ", or "" if it's unknown."""
        return f"line {self.line}: " if self.line is not None else ""

    @property
    def in_line(self) -> str:
        """The line number as a part of a sentence, such as " in line 12", or "" if it's unknown."""
        return f" in line {self.line}" if self.line is not None else ""

    def verdict(self, saw: str, expected: str, *, about_time: bool = False) -> Verdict:
        """Return a failed verdict that blames this error."""
        return failed(self.cause, saw, expected, self.because, self.try_this, about_time=about_time)


_SAYS_NOT_WHICH_NAME = (UNKNOWN_ERROR.cause, "error.module-without-name", "error.import-not-found")
_WITH_AN_ERROR = " with an error"
AN_ERROR_ENDED_IT = f"; the program ended{_WITH_AN_ERROR}"
"""The clause that connects the string `saw` to the error that made the program exit."""
_FATAL = re.compile(r"libgomp: .*Resource temporarily unavailable")
"""Matches the error with which OpenMP (used by PyTorch) terminates a process if the kernel refuses a new thread."""
_EXECUTOR_LEFT = re.compile(
    r"Exception ignored in: <function Executor\.__del__ at \S+>\n"
    + re.escape(TRACEBACK)
    + r":\n(?: .*\n)+\S*InvalidHandle: .*\n?"
)
_THREAD_OVERTAKEN = re.compile(
    r"Exception in thread [^\n]*:\n"
    + re.escape(TRACEBACK)
    + rf":\n(?: [^\n]*\n)*? [^\n]*(?:{SPIN_OVERTAKEN})\n?"
)
_EXECUTOR = "/rclpy/executors.py"


def find_error(log: str, program_name: str = "") -> ProgramError | None:
    """Return the Python error to blame in a program's log, with an explanation, or None if there is none.

    If there are several errors, return the main program's last one (see `main_one`). In a chain of exceptions, return
    the first one (see `first_cause`). If `program_name` is given, only frames in that file determine the line number.
    """
    log = without_executors_end(log)
    chains = chains_in(log)
    in_order = [[one for one in chain if not re.search(OVERTAKEN, one.text)] for chain in chains]
    found = main_one([chain for chain in in_order if chain] or chains, program_name)
    if found is None:
        return _error_of_library(log)
    if found.name == "KeyboardInterrupt":
        return None
    overtaken = re.search(TAKE_OVERTAKEN, found.text)
    excerpt = overtaken[0] if overtaken else found.excerpt
    last = next(reversed([*found.frames()]), None)
    own = last is not None and is_of(last, program_name)
    return _explained(found.error, excerpt, found.line_in(program_name), own=own)


def _error_of_library(log: str) -> ProgramError | None:
    """Return the log's last line as an error if it's OpenMP's reason for terminating the program, or None otherwise.

    A program that OpenMP terminates doesn't print a traceback.
    """
    lines = log.strip().splitlines()
    return _explained(lines[-1], "", None) if lines and _FATAL.match(lines[-1]) else None


def _explained(error: str, excerpt: str, line: int | None, *, own: bool = False) -> ProgramError:
    unknown = unknown_field(excerpt)
    if unknown is not None:
        return ProgramError(error, line, "error.unknown-field", *unknown)
    foreign = foreign_name(error) or name_elsewhere(error)
    if foreign is not None:
        return ProgramError(error, line, *foreign)
    known = next(
        (one for one in KNOWN_ERRORS if re.search(one.pattern, error) or re.search(one.pattern, excerpt)),
        UNKNOWN_ERROR,
    )
    missing = missing_name(error, excerpt, own=own) if known.cause in _SAYS_NOT_WHICH_NAME else None
    if missing is not None:
        return ProgramError(error, line, *missing)
    misfit = value_that_misfits(excerpt)
    if misfit is None:
        return ProgramError(error, line, known.cause, *known.explained())
    cause = known.cause if known.cause.startswith("error.field") else "error.wrong-value-type"
    return ProgramError(error, line, cause, *misfit)


def without_executors_end(log: str) -> str:
    """Return the log without the lines that rclpy may print when a correct program exits.

    - "Exception ignored in Executor.__del__": Python may collect an executor's guard condition before the executor. The
      executor's finalizer then tries to destroy the guard condition again. We saw this twice in a few thousand runs.
    - "Exception in thread", if a thread spins while another thread shuts the context down (see `shutdown_overtaken`).

    Source: https://github.com/ros2/rclpy/blob/jazzy/rclpy/rclpy/executors.py (Executor.__del__, Executor.shutdown).
    """
    return _THREAD_OVERTAKEN.sub("", _EXECUTOR_LEFT.sub("", log))


def failed_while_spinning(log: str) -> bool:
    """Return whether the last Python error in a log was raised while the program was spinning, as in a callback.

    In that case, the traceback contains a frame of rclpy's executor.
    """
    found = main_one(chains_in(without_executors_end(log)), "")
    return found is not None and any(frame["file"].endswith(_EXECUTOR) for frame in found.frames())


def shutdown_overtaken(log: str) -> bool:
    """Return whether a log's only error is that Ctrl-C shut the context down while rclpy was using it.

    `rclpy.try_shutdown()` checks whether the context is valid, and then shuts it down. A spin checks whether the
    context is valid, and then waits. Between the two steps, rclpy's thread that handles Ctrl-C may shut the context
    down. A correct program then exits with a traceback and exit code 1. In our measurement, on two processors with work
    for ten, `try_shutdown` failed in 4 of about 550 runs. A Ctrl-C that arrives while rclpy creates a message leads to
    a different error (see `TAKE_OVERTAKEN`). Any program can print such an error. So the error is a reason to judge the
    program again (`workbook.exercise.inconclusive`), but never a reason to let it pass.

    Sources: https://github.com/ros2/rclpy/blob/jazzy/rclpy/rclpy/context.py (Context.try_shutdown),
    https://github.com/ros2/rclpy/blob/jazzy/rclpy/rclpy/executors.py (Executor._wait_for_ready_callbacks).
    """
    log = without_executors_end(log)
    return log.count(TRACEBACK) == 1 and re.search(OVERTAKEN, log) is not None


def last_error(recording: Recording) -> ProgramError | None:
    """Return the last Python error in the program's log, with an explanation, or None if there is none."""
    return find_error(recording.process.log, recording.process.program)


def failed_by_error(
    recording: Recording, saw: str, expected: str, *, about_time: bool = False
) -> Verdict | None:
    """Return a failed verdict that blames the last Python error in the program's log, or None if there is none.

    `saw` describes the consequence of the error, which is appended to `saw`.
    """
    error = last_error(recording)
    if error is None:
        return None
    if saw:
        joined = saw if saw.endswith(_WITH_AN_ERROR) else f"{saw}; error"
        saw = f"{joined}{error.in_line}: {error.error}"
    else:
        saw = f"{error.where}{error.error}"
    return error.verdict(saw, expected, about_time=about_time)


def failed_at_the_end(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """Return a failed verdict that blames the last Python error after Ctrl-C.

    The result is None if there is no error, or only an error in rclpy's own shutdown. `saw` describes the consequence
    of the error, which is appended to `saw`.
    """
    process = recording.process
    error = None if shutdown_overtaken(process.end_log) else find_error(process.end_log, process.program)
    if error is None:
        return None
    return error.verdict(f"{saw}; error after Ctrl-C{error.in_line}: {error.error}", expected)
