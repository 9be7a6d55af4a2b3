"""How a recorded lesson node has ended."""

from workbook.criteria.vocabulary.known_errors import ended_in_order
from workbook.exercise.inconclusive import crashed_on_interrupt
from workbook.recording.recording import Recording


def ended_well(recording: Recording) -> bool:
    """In order, or by the crash that rclpy now and then makes of Ctrl-C, and that no program can prevent."""
    process = recording.process
    return ended_in_order(process.exit, process.end_log) or bool(crashed_on_interrupt(recording))
