"""Judge how a program exits on Ctrl-C. This needs `watching(to_the_end=True)` in the criteria file."""

import re
from dataclasses import dataclass
from functools import cached_property

from workbook.criteria.rules import Words, otherwise
from workbook.criteria.verdict import Verdict, passed
from workbook.criteria.vocabulary.known_errors import (
    ProgramError,
    find_error,
    shutdown_overtaken,
    without_executors_end,
)
from workbook.criteria.vocabulary.tracebacks import TRACEBACK
from workbook.recording.recording import ProcessRecord, Recording

WORDS = Words(__file__)

_AFTER_THE_END = ("error.exception", "error.destroyed", "error.context-down")
_STILL_RUNNING = re.compile(r"^Still running: (?P<thread>.+)$", re.MULTILINE)
"""Matches a line that `workbook/inside/student_traceback.py` prints."""
_NOT_CAUGHT = re.compile(r"^(Exception (in|ignored)|Task exception)", re.MULTILINE)
"""Matches a line that Python prints for an exception in a thread, finalizer, or task, which the program survives."""


@dataclass(frozen=True)
class _Ending:
    """The exit of a program."""

    process: ProcessRecord

    @property
    def ended_at(self) -> float:
        return self.process.ended_at or 0.0

    @property
    def overtaken(self) -> bool:
        return self.process.exit == 1 and shutdown_overtaken(self.process.end_log)

    @cached_property
    def error(self) -> ProgramError | None:
        return find_error(self.process.end_log, self.process.program)

    @property
    def printed_error(self) -> bool:
        """Whether the program exited with code 0, but printed a ROS error that occurred after the shutdown."""
        if self.error is None or self.process.exit != 0 or self.error.cause not in _AFTER_THE_END:
            return False
        return _NOT_CAUGHT.search(self.process.end_log) is None

    @property
    def printed_traceback(self) -> bool:
        return self.process.exit == 0 and TRACEBACK in without_executors_end(self.process.end_log)

    @property
    def interrupted(self) -> bool:
        return "KeyboardInterrupt" in self.process.end_log

    @property
    def how(self) -> str:
        by_signal = f"ended by signal {self.process.signal}"
        return by_signal if self.process.signal else f"exit code {self.process.exit}"

    @property
    def thread_that_stays(self) -> str:
        """The thread that kept running after Ctrl-C, as the end of a sentence, or "" if it's unknown."""
        found = _STILL_RUNNING.search(self.process.end_log)
        return f"; this thread kept running: {found['thread']}" if found else ""


_CUT_OFF = WORDS.rules(
    _Ending,
    "exits-cleanly",
    ("before-ctrl-c", lambda end: end.process.ended_by == "itself"),
    ("runs-on", lambda end: end.process.signal == "SIGKILL"),
    ("aborted", lambda end: end.process.signal == "SIGABRT"),
    ("crashed", lambda end: end.process.signal == "SIGSEGV"),
    ("overtaken", lambda end: end.overtaken),
    ("prints-an-error", lambda end: end.printed_error),
)
_BY_ERROR = WORDS.seen("exits-cleanly.by-error", _Ending)
_PRINTS_A_TRACEBACK = WORDS.cause("exits-cleanly.prints-a-traceback", _Ending)
_BY_EXIT_CODE = WORDS.rules(
    _Ending,
    "exits-cleanly",
    ("exit-code", lambda end: end.process.signal is None and not end.interrupted),
    ("killed-by-the-signal", lambda end: end.process.signal == "SIGINT" and not end.interrupted),
    ("interrupt-not-caught", otherwise),
)


def exits_cleanly(recording: Recording) -> Verdict:
    """Check that the program exits on Ctrl-C (SIGINT) with exit code 0 and without a traceback.

    If Ctrl-C interrupted rclpy's own shutdown (see `shutdown_overtaken`), the verdict is inconclusive, because any
    program could print the same error. So the judge runs the program again, and only an exit without a traceback
    passes. This check needs `watching(to_the_end=True)`. Raises ValueError if the recording doesn't include the
    program's exit.
    """
    if recording.process.ended_by is None:
        raise ValueError("exits_cleanly needs watching(to_the_end=True) in the criteria file")
    end = _Ending(recording.process)
    cut_off = _CUT_OFF.first(end)
    if cut_off is not None:
        return cut_off
    if end.error is not None:
        return end.error.verdict(*_BY_ERROR(end))
    if end.printed_traceback:
        return _PRINTS_A_TRACEBACK.verdict(end)
    if end.process.exit == 0:
        return passed("ended with exit code 0 after Ctrl-C, no traceback")
    return _BY_EXIT_CODE.verdict(end)
