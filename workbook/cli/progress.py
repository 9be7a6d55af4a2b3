"""`workbook progress`: what a student has done so far."""

import argparse
import sys
from typing import Any


def register(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "progress", help="what you have read, predicted and solved so far", description=__doc__
    )
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Print the table."""
    from workbook.exercise.answer_files import ANSWERS, answers_folder
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.exercise.definition import BrokenCriteria
    from workbook.lesson.progress import all_progress, progress_file
    from workbook.magics.progress_table import progress_table

    try:
        folder = answers_folder()
        if not progress_file(folder).is_file():
            # In a terminal one often stands above the work folder.
            folder = course_folder() / "work" / ANSWERS
        print(progress_table(done=all_progress(folder), answers=folder))
    except (NoCourse, BrokenCriteria, OSError) as error:
        print(f"workbook progress: {error}", file=sys.stderr)
        return 2
    return 0
