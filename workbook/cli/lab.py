"""`workbook lab` and `workbook reset`: open the lessons in JupyterLab, and reset an exercise."""

import argparse
from typing import Any

from workbook.cli import terminal


def register(subparsers: Any) -> None:
    """Add both subcommands."""
    lab = subparsers.add_parser(
        "lab",
        allow_abbrev=False,
        help="open the lessons in JupyterLab (what `make lab` runs)",
        description="Bring your copy of the lessons up to date (in a clone, it is work/) and open it in JupyterLab. "
        "Further arguments go to JupyterLab, for example --no-browser --port=8899.",
    )
    lab.add_argument(
        "--only-copy", action="store_true", help="only bring your copy up to date, without opening JupyterLab"
    )
    lab.set_defaults(run=run_lab, takes_rest=True)
    again = subparsers.add_parser(
        "reset",
        help="reset an exercise, and keep a backup of your version",
        description="Reset an exercise in your copy. Your version is saved in its .state/backups/.",
    )
    again.add_argument("exercise", metavar="EXERCISE", help="such as 09 or joint_positions")
    again.set_defaults(run=run_reset)


def run_lab(options: argparse.Namespace) -> int:
    """Replace this process with JupyterLab or, with --only-copy, only update the student's copy."""
    from workbook.lab.launch import launch

    return _only_copy() if options.only_copy else launch(options.rest)


def _only_copy() -> int:
    """Update the student's copy of the lessons without opening JupyterLab. Return the exit code.

    This is for students who use another editor.
    """
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.lab.launch import CannotLaunch, prepare_copy, student_folder

    try:
        work = student_folder()
        said = prepare_copy(course_folder(), work).lines()
    except (CannotLaunch, NoCourse) as problem:
        terminal.complain("lab", problem)
        return 1
    for line in said or [f"Your copy in {work.name}/ is up to date."]:
        terminal.say(line)
    return 0


def run_reset(options: argparse.Namespace) -> int:
    """Reset an exercise to its starter, and print the paths of the backups. Return the exit code."""
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.lab.launch import student_folder
    from workbook.lab.work_folder import NoSuchExercise, reset

    try:
        course, work = course_folder(), student_folder()
        stem, kept = reset(course, work, options.exercise)
    except (NoCourse, NoSuchExercise) as problem:
        terminal.complain("reset", problem)
        return 2
    print(f"{work.name}/exercises/{stem}.ipynb has been reset.")
    for path in kept:
        print(f"Your version is saved in {path.relative_to(work.parent)}.")
    print("If it is open in JupyterLab, choose File > Reload Notebook from Disk.")
    return 0
