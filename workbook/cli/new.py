"""`workbook new`: the skeleton of a lesson or an exercise, for authors."""

import argparse
import sys
from typing import Any


def register(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "new",
        help="for authors: start a lesson or an exercise with everything the checks demand",
        description="Write the skeleton of a lesson or an exercise and build its notebook. "
        "`make notebooks-check` then lists what you still have to write.",
    )
    parser.add_argument("what", choices=("lesson", "exercise"))
    parser.add_argument(
        "slug", metavar="SLUG", help="slow_callbacks, or 10_slow_callbacks to choose the number"
    )
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Write the files, build the notebook, say what comes next."""
    from workbook.authoring.skeleton import new_exercise, new_lesson
    from workbook.authoring.tree import AuthoringError, Tree
    from workbook.exercise.course import NoCourse, course_folder

    try:
        tree = Tree(course_folder())
        files = (new_lesson if options.what == "lesson" else new_exercise)(tree, options.slug)
    except (AuthoringError, NoCourse) as problem:
        print(f"workbook new: {problem}", file=sys.stderr)
        return 2
    for path in files:
        print(f"written    {tree.name(path)}")
    try:
        from workbook.authoring.building import build_exercise, build_lesson
        from workbook.authoring.pages import write_pages
    except ImportError as missing:
        print(
            f"The notebook is not built: {missing}. `make notebooks` installs what authors need and builds it."
        )
        return 0
    try:
        if options.what == "lesson":
            print(build_lesson(tree, files[0].stem))
        for stem in tree.exercise_stems():  # their links to lessons may have changed
            print(build_exercise(tree, stem))
        for page in write_pages(tree):
            print(f"built      {tree.name(page)}")
    except AuthoringError as problem:
        print(f"workbook new: the notebook could not be built: {problem}", file=sys.stderr)
        return 1
    print("Next: `make notebooks-check` lists what is still to be written. CONTRIBUTING.md explains it.")
    return 0
