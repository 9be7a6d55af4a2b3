"""Finds the error in a program's log and explains it; tells rclpy's own shutdown errors from faults of the program."""

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
    """An error that ended (or crippled) a program: its last line, where it happened, its cause id, why, what to try."""

    error: str
    line: int | None
    cause: str
    because: str
    try_this: str

    @property
    def where(self) -> str:
        """The line number as a prefix for a message, "line 12: "; empty when the line is not known."""
        return f"line {self.line}: " if self.line is not None else ""


_SAYS_NOT_WHICH_NAME = (UNKNOWN_ERROR.cause, "error.module-without-name", "error.import-not-found")
_FATAL = re.compile(r"libgomp: .*Resource temporarily unavailable")
"""PyTorch and others start their threads by OpenMP, which ends the process when the kernel refuses one."""
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
    """The Python error to blame in a program's log, explained; None if there is none.

    Of several it is the last one of the main program; of chained ones the first: see `main_one` and `first_cause`.
    Only frames of the student's own file (`program_name`) give the line number, when the name is known.
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
    told = overtaken[0] if overtaken else found.told
    last = next(reversed([*found.frames()]), None)
    own = last is not None and is_of(last, program_name)
    return _explained(found.error, told, found.line_in(program_name), own=own)


def _error_of_library(log: str) -> ProgramError | None:
    """The last line of a log, if OpenMP says in it why it has ended the program: then there is no traceback."""
    lines = log.strip().splitlines()
    return _explained(lines[-1], "", None) if lines and _FATAL.match(lines[-1]) else None


def _explained(error: str, told: str, line: int | None, *, own: bool = False) -> ProgramError:
    unknown = unknown_field(told)
    if unknown is not None:
        return ProgramError(error, line, "error.unknown-field", unknown.because, unknown.try_this)
    foreign = foreign_name(error) or name_elsewhere(error)
    if foreign is not None:
        return ProgramError(error, line, *foreign)
    for known in KNOWN_ERRORS:
        if re.search(known.pattern, error) or re.search(known.pattern, told):
            break
    else:
        known = UNKNOWN_ERROR
    missing = missing_name(error, told, own=own) if known.cause in _SAYS_NOT_WHICH_NAME else None
    if missing is not None:
        return ProgramError(error, line, *missing)
    field = value_that_misfits(told)
    if field is None:
        return ProgramError(error, line, known.cause, known.because, known.try_this)
    cause = known.cause if known.cause.startswith("error.field") else "error.wrong-value-type"
    return ProgramError(error, line, cause, field.because, field.try_this)


def without_executors_end(log: str) -> str:
    """The log without what rclpy prints at the end of a program that has done nothing wrong.

    - "Exception ignored in Executor.__del__": Python may collect an executor's guard condition before the executor,
      whose finalizer then tries to destroy it once more. Seen twice in some thousand ends.
    - "Exception in thread" from a thread that spins while another one shuts the context down: see `shutdown_overtaken`.

    Source: https://github.com/ros2/rclpy/blob/jazzy/rclpy/rclpy/executors.py (Executor.__del__, Executor.shutdown).
    """
    return _THREAD_OVERTAKEN.sub("", _EXECUTOR_LEFT.sub("", log))


def failed_while_spinning(log: str) -> bool:
    """Whether the last Python error in a log came out of a callback: rclpy's executor is among the calls above it."""
    found = main_one(chains_in(without_executors_end(log)), "")
    return found is not None and any(frame["file"].endswith(_EXECUTOR) for frame in found.frames())


def shutdown_overtaken(log: str) -> bool:
    """Whether the only error in a log is that Ctrl-C shut the context down in the middle of rclpy's own work.

    `rclpy.try_shutdown()` checks whether the context is up, and then shuts it down. A spin checks whether it is up, and
    then waits. The thread of rclpy that handles Ctrl-C may shut it down in between; then a correct program ends with a
    traceback and exit code 1. Measured: `try_shutdown` 4 of about 550 ends on two processors with work for ten.
    And a Ctrl-C that comes while rclpy makes a message comes out as another error: see `TAKE_OVERTAKEN`.
    Any program can print this text, so it is a reason to look again (`conclusiveness`), and never one to forgive.
    Sources: https://github.com/ros2/rclpy/blob/jazzy/rclpy/rclpy/context.py (Context.try_shutdown),
    https://github.com/ros2/rclpy/blob/jazzy/rclpy/rclpy/executors.py (Executor._wait_for_ready_callbacks).
    """
    log = without_executors_end(log)
    return log.count(TRACEBACK) == 1 and re.search(OVERTAKEN, log) is not None


def ended_in_order(exit_code: int | None, end_log: str) -> bool:
    """Whether a program ended with exit code 0 and no traceback, apart from rclpy's own shutdown errors.

    For programs that are trusted: see `shutdown_overtaken` and `without_executors_end`.
    """
    if exit_code == 1:
        return shutdown_overtaken(end_log)
    return exit_code == 0 and TRACEBACK not in without_executors_end(end_log)


def last_error(recording: Recording) -> ProgramError | None:
    """The last Python error in the log of the program, explained; None if there is none."""
    return find_error(recording.process.log, recording.process.program)


def failed_by_error(
    recording: Recording, saw: str, expected: str, *, about_time: bool = False
) -> Verdict | None:
    """A failed verdict that blames the last Python error in the program's log; None if there is none.

    `saw` says what is missing because of it; the error is put behind it.
    """
    error = last_error(recording)
    if error is None:
        return None
    told = f"{error.where}{error.error}"
    return failed(
        error.cause,
        f"{saw}: {told}" if saw else told,
        expected,
        error.because,
        error.try_this,
        about_time=about_time,
    )


def failed_at_the_end(recording: Recording, saw: str, expected: str) -> Verdict | None:
    """A failed verdict that blames the last Python error after Ctrl-C; None if there is none, or only rclpy's own.

    `saw` says what is missing because of it; the error is put behind it.
    """
    process = recording.process
    error = None if shutdown_overtaken(process.end_log) else find_error(process.end_log, process.program)
    if error is None:
        return None
    told = f"{saw}; error after Ctrl-C: {error.where}{error.error}"
    return failed(error.cause, told, expected, error.because, error.try_this)
