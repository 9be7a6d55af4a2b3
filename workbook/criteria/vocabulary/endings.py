"""Judges how a program ends on Ctrl-C. Needs `watching(to_the_end=True)` in the criteria file."""

import re

from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.known_errors import (
    ProgramError,
    find_error,
    shutdown_overtaken,
    without_executors_end,
)
from workbook.criteria.vocabulary.phrasing import seconds
from workbook.criteria.vocabulary.tracebacks import TRACEBACK
from workbook.recording.recording import ProcessRecord, Recording

_AFTER_THE_END = ("error.exception", "error.destroyed", "error.context-down")
_EXPECTED = "exit code 0 and no traceback after Ctrl-C"
_INTERRUPT = "KeyboardInterrupt"
_STILL_RUNNING = re.compile(r"^Still running: (?P<thread>.+)$", re.MULTILINE)
"""What `workbook/inside/student_traceback.py` prints."""
_NOT_CAUGHT = re.compile(r"^(Exception (in|ignored)|Task exception)", re.MULTILINE)
"""Python prints this for an exception that does not end the program: in a thread, a finalizer or a task."""


def exits_cleanly(recording: Recording) -> Verdict:
    """On Ctrl-C (SIGINT) the program ends with exit code 0 and without a traceback.

    An end that Ctrl-C overtook is none of these (see `shutdown_overtaken`): a program may print the same, so the end is
    watched again, and only one without a traceback counts.

    Needs `watching(to_the_end=True)`; raises ValueError when the recording does not hold the end.
    """
    process = recording.process
    if process.ended_by is None:
        raise ValueError("exits_cleanly needs watching(to_the_end=True) in the criteria file")
    if process.ended_by == "itself":
        return failed(
            "exits-cleanly.before-ctrl-c",
            f"the program ended by itself after {seconds(process.ended_at or 0.0)}, before Ctrl-C was sent",
            _EXPECTED,
            "Nothing keeps it alive, or an error ended it.",
            "Keep it running with rclpy.spin(node) first.",
        )
    if process.signal in ("SIGKILL", "SIGABRT", "SIGSEGV"):
        return _by_signal(process)
    if process.exit == 1 and shutdown_overtaken(process.end_log):
        return failed(
            "exits-cleanly.overtaken",
            "exit code 1 after Ctrl-C, with a traceback from rclpy's own spin or shutdown",
            _EXPECTED,
            "Occasionally, rclpy's own Ctrl-C handler shuts the context down in the middle of a spin or a "
            "shutdown. That isn't your program's fault, so the judge starts it again, up to two times. One run "
            "that ends without a traceback is enough.",
            "Run it again. If it always ends like this, check what your program does and prints after Ctrl-C: "
            "main() should return after rclpy.try_shutdown().",
        )
    error = find_error(process.end_log, process.program)
    return _by_exit_code(process) if error is None else _by_error(process, error)


def _by_error(process: ProcessRecord, error: ProgramError) -> Verdict:
    saw = f"after Ctrl-C: {error.where}{error.error} (exit code {process.exit})"
    if process.exit == 0 and error.cause in _AFTER_THE_END and not _NOT_CAUGHT.search(process.end_log):
        return failed(
            "exits-cleanly.prints-an-error",
            saw,
            _EXPECTED,
            "The program caught this exception and ended normally, but it printed the traceback.",
            "Find the call that raises it. Ctrl-C shuts the context down, so don't use ROS after that.",
        )
    return failed(error.cause, saw, _EXPECTED, error.because, error.try_this)


def _by_exit_code(process: ProcessRecord) -> Verdict:
    if process.exit == 0 and TRACEBACK in without_executors_end(process.end_log):
        return failed(
            "exits-cleanly.prints-a-traceback",
            "exit code 0 after Ctrl-C, but it printed a traceback",
            _EXPECTED,
            "The program catches the exception but prints the traceback itself.",
            "Do not print the traceback: Ctrl-C is not an error.",
        )
    if process.exit == 0:
        return passed("ended with exit code 0 after Ctrl-C, no traceback")
    if process.signal is None and _INTERRUPT not in process.end_log:
        return failed(
            "exits-cleanly.exit-code",
            f"exit code {process.exit} after Ctrl-C, without a traceback",
            _EXPECTED,
            "The program sets this exit code itself, with sys.exit(), os._exit() or SystemExit. Any exit code "
            "other than 0 reports an error.",
            "Let main() return after Ctrl-C, or call sys.exit(0).",
        )
    if process.signal == "SIGINT" and _INTERRUPT not in process.end_log:
        return failed(
            "exits-cleanly.killed-by-the-signal",
            "ended by signal SIGINT after Ctrl-C, without a KeyboardInterrupt",
            _EXPECTED,
            "The signal ended the program before Python could handle it. That happens after "
            "signal.signal(signal.SIGINT, signal.SIG_DFL), or through os.kill().",
            "Leave the handling of SIGINT as it is, and catch KeyboardInterrupt around rclpy.spin(node).",
        )
    how = f"ended by signal {process.signal}" if process.signal else f"exit code {process.exit}"
    return failed(
        "exits-cleanly.interrupt-not-caught",
        f"{how} after Ctrl-C{_thread_that_stays(process)}",
        _EXPECTED,
        "KeyboardInterrupt leaves main(): nothing catches it, or it is raised again.",
        "Wrap rclpy.spin(node) in try/except (KeyboardInterrupt, ExternalShutdownException), and call "
        "rclpy.try_shutdown() in finally.",
    )


def _thread_that_stays(process: ProcessRecord) -> str:
    """The thread that kept running after Ctrl-C, as the end of a sentence; empty if none is known."""
    found = _STILL_RUNNING.search(process.end_log)
    return f"; this thread kept running: {found['thread']}" if found else ""


def _by_signal(process: ProcessRecord) -> Verdict:
    if process.signal == "SIGKILL":
        return failed(
            "exits-cleanly.runs-on",
            f"it kept running after Ctrl-C and had to be killed{_thread_that_stays(process)}",
            _EXPECTED,
            "KeyboardInterrupt is caught inside a loop, or the signal is ignored. Or the program waits for "
            "something at its end, such as a thread, a lock, or input.",
            "Catch KeyboardInterrupt only around rclpy.spin(node), and don't wait for anything after that.",
        )
    if process.signal == "SIGABRT":
        return failed(
            "exits-cleanly.aborted",
            "it aborted when it ended (SIGABRT)",
            _EXPECTED,
            "A thread was still spinning when the Python interpreter shut down.",
            "Shut the executor down first, then join its thread.",
        )
    return failed(
        "exits-cleanly.crashed",
        "it crashed after Ctrl-C (SIGSEGV)",
        _EXPECTED,
        "A thread was still using the node or its context when they were destroyed. On a very busy machine, a bug "
        "in rclpy can also cause this.",
        "Run it again. If it crashes again, shut the executor down first, join its thread, and call "
        "rclpy.try_shutdown() last.",
    )
