"""`workbook restore`: make the best version of an answer that was ever judged the file to hand in again."""

import argparse
from typing import Any

from workbook.cli import terminal


def register(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "restore",
        help="restore your best judged version as the file to hand in",
        description="Restore your best judged version as the file to hand in. Your current version is kept in "
        "answers/.previous/.",
    )
    parser.add_argument("exercise", metavar="EXERCISE", help="09_joint_positions, joint_positions or 9")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Restore the best version, and print the paths of that version and of the replaced one. Return the exit code."""
    from workbook.cli.paths import as_typed, student_answers
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.exercise.source import UnknownExercise, find
    from workbook.lesson.best_answers import NothingJudged, best_text, hands_in_another, restore_best

    try:
        stem = find(course_folder() / "solutions", options.exercise).stem
        folder = student_answers()
        if best_text(stem, folder) is not None and not hands_in_another(stem, folder):
            print(f"{as_typed(folder / f'{stem}.py')} already is your best version.")
            return 0
        saved = restore_best(stem, folder)
    except BrokenPipeError:
        raise
    except (NoCourse, UnknownExercise, NothingJudged, OSError) as problem:
        terminal.complain("restore", problem)
        return 2
    print(f"{as_typed(saved.path)} is your best version again.")
    if saved.previous is not None:
        print(f"The previous version is kept as {as_typed(saved.previous)}.")
    print(f"If its notebook is open, run %restore {stem[:2]} there: it changes the answer cell, too.")
    return 0
