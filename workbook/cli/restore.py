"""`workbook restore`: the best version of an answer that was ever judged becomes the file to hand in again."""

import argparse
import sys
from typing import Any


def register(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "restore",
        help="make the best version of your answer the file to hand in again",
        description="Make the best version that was ever judged the file to hand in again. The one you have now is "
        "kept in answers/.previous/.",
    )
    parser.add_argument("exercise", metavar="EXERCISE", help="09_joint_positions, joint_positions or 9")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Restore, and say what became of both versions."""
    from workbook.exercise.answer_files import ANSWERS, answers_folder
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.exercise.source import UnknownExercise, find
    from workbook.lesson.best_answers import NothingJudged, best_file, hands_in_another, restore_best

    try:
        course = course_folder()
        stem = find(course / "solutions", options.exercise).stem
        folder = answers_folder()
        if not best_file(stem, folder).is_file():
            folder = course / "work" / ANSWERS  # in a terminal one often stands above the work folder
        if best_file(stem, folder).is_file() and not hands_in_another(stem, folder):
            print(f"{ANSWERS}/{stem}.py is your best version already.")
            return 0
        saved = restore_best(stem, folder)
    except (NoCourse, UnknownExercise, NothingJudged, OSError) as problem:
        print(f"workbook restore: {problem}", file=sys.stderr)
        return 2
    print(f"{saved.path} is your best version again.")
    if saved.previous is not None:
        print(f"The one before is kept as {saved.previous}.")
    print(f"If its notebook is open, run %restore {stem[:2]} there: it changes the answer cell as well.")
    return 0
