"""Judge how one of the course's own programs has ended."""

from workbook.criteria.vocabulary.known_errors import shutdown_overtaken, without_executors_end
from workbook.criteria.vocabulary.tracebacks import TRACEBACK
from workbook.exercise.inconclusive import crashed_on_interrupt
from workbook.recording.recording import Recording


def ended_in_order(exit_code: int | None, end_log: str) -> bool:
    """Return whether it ended with exit code 0 and no traceback, apart from rclpy's own shutdown errors.

    For trusted programs only: see `shutdown_overtaken` and `without_executors_end`.
    """
    if exit_code == 1:
        return shutdown_overtaken(end_log)
    return exit_code == 0 and TRACEBACK not in without_executors_end(end_log)


def ended_well(recording: Recording) -> bool:
    """Return whether it ended in order, or in an rclpy crash on Ctrl-C that no program can prevent."""
    process = recording.process
    return ended_in_order(process.exit, process.end_log) or bool(crashed_on_interrupt(recording))
