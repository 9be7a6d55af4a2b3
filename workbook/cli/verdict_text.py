"""Format a judgment for `workbook check`, and define its exit codes."""

from typing import TYPE_CHECKING

from workbook.cli import terminal

if TYPE_CHECKING:
    from workbook.exercise.judgement import Judgement

FULL_MARKS, NOT_YET, NOT_JUDGED = 0, 1, 2


def verdict_text(judgement: "Judgement", color: bool) -> str:
    """Format the judgment to fit the terminal's width."""
    from workbook.feedback import wording
    from workbook.feedback.text import as_text

    return as_text(judgement, color, exhibit=wording.exhibit_of(judgement), width=terminal.width())
