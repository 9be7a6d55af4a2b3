"""`workbook new`: create a small but complete lesson or exercise for an author to start from."""

import argparse
import sys
from typing import Any

from workbook.cli import terminal

TEMPLATES = ("publisher", "listener", "service", "function")
"""A copy of the template names in `workbook.authoring.skeleton`, which is imported only when it's needed."""


def register(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "new",
        help="for authors: start a lesson or an exercise from a template that passes every check",
        description="Write a small lesson or exercise that passes every check as it is, and build its notebook. Then "
        "make it your own, step by step; CONTRIBUTING.md explains how.",
    )
    parser.add_argument("what", metavar="KIND", choices=("lesson", "exercise"), help="lesson or exercise")
    parser.add_argument(
        "slug", metavar="SLUG", help="slow_callbacks, or 10_slow_callbacks to choose the number"
    )
    parser.add_argument(
        "--template",
        choices=TEMPLATES,
        help="what an exercise is about. A publisher has a rate and a value (the default). A listener reacts to a "
        "sensor. A service answers calls. A function is called by a driver",
    )
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Write the files, build the notebooks and pages that depend on them, and print the next steps.

    Return the exit code.
    """
    from workbook.authoring.skeleton import new_exercise, new_lesson
    from workbook.authoring.tree import AuthoringError, Tree
    from workbook.exercise.course import NoCourse, course_folder

    if options.what == "lesson" and options.template is not None:
        terminal.complain("new", "there is one template for lessons: leave out --template")
        return 2
    try:
        tree = Tree(course_folder())
        if options.what == "lesson":
            files = new_lesson(tree, options.slug)
        else:
            files = new_exercise(tree, options.slug, options.template or TEMPLATES[0])
    except (AuthoringError, NoCourse) as problem:
        terminal.complain("new", problem)
        return 2
    for path in files:
        print(f"written    {tree.name(path)}")
    try:
        from workbook.authoring.building import build
    except ImportError as missing:
        print(
            f"The notebook is not built: {missing}. `make notebooks` installs the authors' tools and builds it."
        )
        return 0
    if build(tree, say=lambda words: None if words.startswith("unchanged") else print(words)):
        print("workbook new: not everything could be built; see above", file=sys.stderr)
        return 1
    stem = files[0].stem
    if options.what == "exercise" and not any(other[:2] == stem[:2] for other in tree.lesson_stems()):
        print(f"Next: `workbook new lesson {stem}`, because each exercise has a lesson that leads to it.")
    print(
        "`make notebooks-check ARGS=--notes` lists the lines that still come from the template. "
        "CONTRIBUTING.md explains it."
    )
    return 0
