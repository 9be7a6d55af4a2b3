"""`python -m workbook.authoring build|check|compare|typings`: what `make notebooks` and `make notebooks-check` run."""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path

from workbook.authoring.building import build
from workbook.authoring.checking import check, report
from workbook.authoring.comparing import compare
from workbook.authoring.tree import AuthoringError, Tree
from workbook.exercise.course import course_folder


def parser() -> argparse.ArgumentParser:
    """The command line."""
    top = argparse.ArgumentParser(
        prog="python -m workbook.authoring", description="Lessons and exercises from text."
    )
    top.add_argument(
        "--course", type=Path, default=None, help="folder of the course (default: this checkout)"
    )
    commands = top.add_subparsers(dest="command", required=True)
    building = commands.add_parser("build", help="build the notebooks whose text has changed, and run those")
    building.add_argument("names", nargs="*", metavar="STEM", help="lessons and exercises; all if none")
    building.add_argument(
        "--all", action="store_true", dest="again", help="run lessons that did not change, too"
    )
    building.add_argument("--jobs", type=int, default=1, help="lessons that run at once")
    commands.add_parser(
        "check", help="fail when a notebook differs from its text, or a file is missing or misplaced"
    )
    commands.add_parser("typings", help="make the stubs of the message packages anew (workbook/typings)")
    comparing = commands.add_parser("compare", help="run notebooks under nbval and compare their outputs")
    comparing.add_argument("names", nargs="*", metavar="STEM", help="lessons and exercises; all if none")
    comparing.add_argument("--jobs", type=int, default=1, help="notebooks that run at once")
    comparing.add_argument("--junit", type=Path, default=None, help="also write a JUnit report to this file")
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Exit code 0 when all is well, 1 when something is to be mended."""
    options = parser().parse_args(arguments)
    tree = Tree((options.course or course_folder()).resolve())
    try:
        if options.command == "build":
            failed = build(tree, options.names, again=options.again, jobs=options.jobs)
            if failed:
                print(f"{failed} could not be built.", file=sys.stderr)
            return 1 if failed else 0
        if options.command == "compare":
            extra = [f"--junitxml={options.junit.resolve()}"] if options.junit else []
            return compare(tree, options.names, jobs=options.jobs, extra=extra)
    except AuthoringError as error:
        print(error, file=sys.stderr)
        return 1
    if options.command == "typings":
        from workbook.authoring.typings import write

        print(f"{write()} stubs written")
        return 0
    found = check(tree)
    if found:
        print(report(found))
        print(f"\n{len(found)} to mend.", file=sys.stderr)
        return 1
    print(
        f"{len(tree.lesson_stems())} lessons and {len(tree.exercise_stems())} exercises: all as their texts say."
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
