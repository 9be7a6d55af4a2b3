"""`workbook lab` and `workbook reset`."""

import argparse
from typing import Any

from workbook.cli import terminal


def register(subparsers: Any) -> None:
    """Add both subcommands."""
    lab = subparsers.add_parser(
        "lab",
        allow_abbrev=False,
        help="open the lessons in JupyterLab (what `make lab` runs)",
        description="Bring your copy in work/ up to date and open it in JupyterLab. "
        "Further arguments go to JupyterLab, for example --no-browser --port=8899.",
    )
    lab.add_argument(
        "--only-copy", action="store_true", help="bring your copy in work/ up to date, and open nothing"
    )
    lab.set_defaults(run=run_lab, takes_rest=True)
    again = subparsers.add_parser(
        "reset",
        help="reset an exercise in work/, keeping a backup of yours",
        description="Reset an exercise in work/. What you had is kept in work/.state/backups/.",
    )
    again.add_argument("exercise", metavar="EXERCISE", help="such as 09 or joint_positions")
    again.set_defaults(run=run_reset)


def run_lab(options: argparse.Namespace) -> int:
    """Become JupyterLab."""
    from workbook.lab.launch import launch

    return _only_copy() if options.only_copy else launch(options.rest)


def _only_copy() -> int:
    """Bring the student's copy up to date, for those who open it in another editor."""
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.lab.launch import student_folder
    from workbook.lab.work_folder import update_work_folder

    try:
        said = update_work_folder(course_folder(), student_folder()).lines()
    except (NoCourse, OSError) as problem:
        terminal.complain("lab", problem)
        return 1
    for line in said or ["Your copy in work/ is up to date."]:
        terminal.say(line)
    return 0


def run_reset(options: argparse.Namespace) -> int:
    """Restore the starter of one exercise."""
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.lab.launch import student_folder
    from workbook.lab.work_folder import NoSuchExercise, reset

    try:
        course, work = course_folder(), student_folder()
        stem, kept = reset(course, work, options.exercise)
    except (NoCourse, NoSuchExercise) as problem:
        terminal.complain("reset", problem)
        return 2
    print(f"work/exercises/{stem}.ipynb has been reset.")
    for path in kept:
        print(f"What you had is in {path.relative_to(course)}.")
    print("If it is open in JupyterLab, choose File > Reload Notebook from Disk.")
    return 0
