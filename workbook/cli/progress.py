"""`workbook progress`: show a student's progress."""

import argparse
from typing import Any

from workbook.cli import terminal


def register(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "progress",
        help="your progress: lessons read, predictions made, exercises solved",
        description="Show your progress: lessons read, predictions made, exercises solved.",
    )
    parser.set_defaults(run=run)


def run(_options: argparse.Namespace) -> int:
    """Print the progress table. Return the exit code."""
    from workbook.cli.paths import student_answers
    from workbook.exercise.course import NoCourse
    from workbook.exercise.definition import BrokenCriteria
    from workbook.magics.progress_table import progress_table

    try:
        print(progress_table(answers=student_answers()).text(terminal.width()))
    except BrokenPipeError:
        raise
    except (NoCourse, BrokenCriteria, OSError) as error:
        terminal.complain("progress", error)
        return 2
    return 0
