"""`workbook package`: build the students' edition, or the files that Gradescope or a class repository needs."""

import argparse
import os
from collections.abc import Callable
from pathlib import Path

from workbook.cli import terminal


def register(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand `package` with an action for each target: students, Gradescope, and GitHub."""
    parser = subparsers.add_parser(
        "package",
        help="for instructors: the students' edition, an autograder for Gradescope, a class repository",
        description="Package the course for students, or for a system that judges answers as `workbook grade` does.",
    )
    places = parser.add_subparsers(title="places", metavar="PLACE", required=True)
    edition = places.add_parser(
        "students", help="the course without solutions: a folder for a repository, or a zip file"
    )
    edition.add_argument(
        "--out",
        metavar="DIR",
        required=True,
        type=Path,
        help="a new folder, an earlier edition to bring up to date, or FILE.zip",
    )
    edition.set_defaults(run=run_students)
    scope = places.add_parser("gradescope", help="an autograder: a zip file to upload")
    scope.add_argument("exercise", metavar="EXERCISE", help="such as joint_positions")
    scope.add_argument("--out", metavar="FILE.zip", required=True, type=Path, help="where to write it")
    scope.add_argument(
        "--criteria",
        metavar="FOLDER",
        type=Path,
        help="a folder with your own hidden criteria (NN_slug.py) to include",
    )
    scope.set_defaults(run=run_gradescope)
    github = places.add_parser("github", help="a GitHub Actions workflow for a class repository")
    github.add_argument("exercises", metavar="EXERCISE", nargs="+", help="such as joint_positions")
    github.add_argument("--out", metavar="FOLDER", required=True, type=Path, help="the class repository")
    github.add_argument(
        "--course",
        metavar="ADDRESS",
        help="the address that git fetches the course from (default: your origin)",
    )
    github.add_argument(
        "--revision", metavar="COMMIT", help="the course's full commit ID (default: your current commit)"
    )
    github.add_argument(
        "--reporter", action="store_true", help="also pass the points to GitHub Classroom's reporter"
    )
    github.set_defaults(run=run_github)


def run_students(options: argparse.Namespace) -> int:
    """Write the students' edition. Return the exit code."""
    from workbook.exercise.course import course_folder
    from workbook.grading.students_edition import students_edition

    def work() -> int:
        edition = students_edition(course_folder(), options.out)
        removed = f", {len(edition.removed)} from an earlier edition removed" if edition.removed else ""
        print(f"Written: {options.out} ({len(edition.files)} files{removed}), the students' edition.")
        print("It contains no solutions, no right or wrong answers, and no pages for instructors.")
        print("Before you give it away, test it: run `make test` in that folder.")
        return 0

    return _run(work)


def run_gradescope(options: argparse.Namespace) -> int:
    """Write an exercise's autograder for Gradescope as a zip file. Return the exit code."""
    from workbook.exercise.course import course_folder
    from workbook.exercise.definition import OWN_CRITERIA, load_exercise, own_criteria
    from workbook.grading.packaging import CannotPackage, gradescope_zip

    def work() -> int:
        if options.criteria is not None:
            if not options.criteria.is_dir():
                raise CannotPackage(f"--criteria {options.criteria}: there is no such folder")
            os.environ[OWN_CRITERIA] = str(options.criteria.resolve())
        exercise = load_exercise(options.exercise)
        if options.criteria is not None and own_criteria(exercise.stem) is None:
            raise CannotPackage(f"--criteria {options.criteria}: the folder has no {exercise.stem}.py")
        names = gradescope_zip(exercise, course_folder(), options.out)
        size = options.out.stat().st_size / 1e6
        print(
            f"Written: {options.out} ({len(names)} files, {size:.1f} MB), the autograder of {exercise.stem}."
        )
        print(
            f"In Gradescope, create a Programming Assignment with {exercise.max_points:g} autograder points, and "
            "upload the file under Configure Autograder. For details, see exercises/README.md."
        )
        return 0

    return _run(work)


def run_github(options: argparse.Namespace) -> int:
    """Write a GitHub Actions workflow into a class repository. Return the exit code."""
    from workbook.exercise.course import course_folder
    from workbook.exercise.definition import load_exercise
    from workbook.grading.packaging import classroom_workflow, commit_of, origin_of

    def work() -> int:
        exercises = [load_exercise(name) for name in options.exercises]
        address = options.course or origin_of(course_folder())
        revision = options.revision or commit_of(course_folder())
        path = classroom_workflow(exercises, options.out, address, revision, reporter=options.reporter)
        print(f"Written: {path}. It judges {', '.join(one.stem for one in exercises)}")
        print(f"with the course at {address}, commit {revision}. Others must be able to fetch that commit.")
        return 0

    return _run(work)


def _run(work: "Callable[[], int]") -> int:
    """Run an action, and return its exit code. If an expected error occurs, print it as a message, and return 2."""
    from workbook.exercise.course import NoCourse
    from workbook.exercise.definition import BrokenCriteria
    from workbook.exercise.source import SourceError, UnknownExercise
    from workbook.grading.packaging import CannotPackage

    try:
        return work()
    except BrokenPipeError:
        raise
    except (CannotPackage, NoCourse, BrokenCriteria, SourceError, UnknownExercise, OSError) as error:
        terminal.complain("package", error)
        return 2
