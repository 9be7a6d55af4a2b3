"""`python -m workbook.authoring build|check|compare|dist|mutants|robot|typings`: what the Makefile runs for authors."""

import argparse
import sys
from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path

from workbook.authoring.building import build, select
from workbook.authoring.checking import check
from workbook.authoring.comparing import compare
from workbook.authoring.mutants.staleness import outdated_reports
from workbook.authoring.skeleton import still_from_template
from workbook.authoring.tree import AuthoringError, Tree
from workbook.authoring.violations import report
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
    checking = commands.add_parser(
        "check", help="fail when a notebook differs from its text, or a file is missing or misplaced"
    )
    checking.add_argument(
        "--notes",
        action="store_true",
        help="also list what is still the text of a template, and reports that are out of date; that is no failure",
    )
    packing = commands.add_parser("dist", help="build the wheel for students")
    packing.add_argument("--out", type=Path, default=None, help="folder for it (default: dist/)")
    commands.add_parser("typings", help="make the stubs of the message packages anew (workbook/typings)")
    commands.add_parser(
        "robot", help="record the robot and draw the picture of the README anew (docs/robot.png)"
    )
    mutating = commands.add_parser("mutants", help="say which small faults of right programs get full marks")
    mutating.add_argument("--only", nargs="+", default=(), metavar="STEM", help="exercises; all if none")
    mutating.add_argument("--most", type=int, default=120, help="mutants that are judged for each exercise")
    mutating.add_argument("--slots", type=int, default=None, help="programs that run at once")
    comparing = commands.add_parser("compare", help="run notebooks under nbval and compare their outputs")
    comparing.add_argument("names", nargs="*", metavar="STEM", help="lessons and exercises; all if none")
    comparing.add_argument("--jobs", type=int, default=1, help="notebooks that run at once")
    comparing.add_argument("--junit", type=Path, default=None, help="also write a JUnit report to this file")
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Exit code 0 when all is well, 1 when something is to be fixed."""
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
        if options.command == "mutants":
            from workbook.authoring.mutants.running import on_slots, report_mutants

            _, stems = select(tree, options.only)
            report_mutants(tree, stems, on_slots(options.slots), most=options.most)
            return 0
    except AuthoringError as error:
        print(error, file=sys.stderr)
        return 1
    if options.command == "dist":
        from workbook.authoring.wheel import build_wheel

        wheel = build_wheel(tree.root, options.out or tree.root / "dist")
        print(f"built      {wheel} ({wheel.stat().st_size / 1e6:.1f} MB)")
        print(f"SHA-256    {sha256(wheel.read_bytes()).hexdigest()}")
        return 0
    if options.command == "typings":
        from workbook.authoring.typings import write

        print(f"{write()} stubs written")
        return 0
    if options.command == "robot":
        from workbook.authoring.robot_picture import write_robot_picture

        print(f"built      {tree.name(write_robot_picture(tree))}")
        return 0
    return run_check(tree, notes=options.notes)


def run_check(tree: Tree, *, notes: bool) -> int:
    """Print what breaks a rule; then, as notes, what is still the text of a template."""
    found = check(tree)
    if found:
        print(report(found))
        print(f"\n{len(found)} to fix.", file=sys.stderr)
    else:
        lessons, exercises = len(tree.lesson_stems()), len(tree.exercise_stems())
        print(f"{lessons} lessons and {exercises} exercises: all match their texts.")
    left = list(still_from_template(tree))
    if left and notes:
        print(f"\nNotes: {len(left)} lines of a template are still to be replaced.\n{report(left)}")
    elif left:
        print(
            f"{len(left)} lines are still those of a template: `make notebooks-check ARGS=--notes` lists them."
        )
    outdated = list(outdated_reports(tree)) if notes else []
    if outdated:
        print(f"\nNotes: {len(outdated)} reports on mutants are out of date.\n{report(outdated)}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
