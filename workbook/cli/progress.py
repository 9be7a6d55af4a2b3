"""`workbook progress`: what a student has done so far."""

import argparse
import sys
from typing import Any


def register(subparsers: Any) -> None:
    parser = subparsers.add_parser(
        "progress", help="what you have read, predicted and solved so far", description=__doc__
    )
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.exercise.definition import BrokenCriteria
    from workbook.magics.answers import ANSWERS
    from workbook.magics.overview import overview
    from workbook.magics.progress import all_progress, progress_file

    try:
        kept = all_progress()
        if not kept and not progress_file().is_file():
            # In a terminal one often stands above the work folder.
            kept = all_progress(course_folder() / "work" / ANSWERS)
        print(overview(done=kept))
    except (NoCourse, BrokenCriteria, OSError) as error:
        print(f"workbook progress: {error}", file=sys.stderr)
        return 2
    return 0
