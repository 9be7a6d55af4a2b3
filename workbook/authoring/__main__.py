"""The command line for authors: `python -m workbook.authoring build|check|compare|...`, which the Makefile runs."""

import argparse
import sys
from collections.abc import Sequence
from hashlib import sha256
from pathlib import Path

from workbook.authoring.building import build, select
from workbook.authoring.checking import check
from workbook.authoring.colab import PACKAGE, lessons_for_colab
from workbook.authoring.comparing import compare
from workbook.authoring.mutants.staleness import outdated_reports
from workbook.authoring.skeleton import still_from_template
from workbook.authoring.tree import AuthoringError, Tree
from workbook.authoring.violations import report
from workbook.exercise.course import course_folder


def parser() -> argparse.ArgumentParser:
    """Create the command-line parser."""
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
    building.add_argument("--jobs", type=int, default=1, help="lessons that run at the same time")
    checking = commands.add_parser(
        "check", help="fail when a notebook differs from its text, or a file is missing or misplaced"
    )
    checking.add_argument(
        "--notes",
        action="store_true",
        help="also list lines that a template wrote, and reports that are out of date; neither is a failure",
    )
    packing = commands.add_parser("dist", help="build the wheel for students")
    packing.add_argument("--out", type=Path, default=None, help="folder for it (default: dist/)")
    colab = commands.add_parser("colab", help="write the lessons with a first cell that installs the course")
    colab.add_argument("--out", type=Path, default=None, help="folder for them (default: build/colab)")
    colab.add_argument(
        "--package", default=PACKAGE, help="what pip installs: a name or an address of a wheel"
    )
    site = commands.add_parser("site", help="write the site: every page of the course for a browser")
    site.add_argument("--out", type=Path, default=None, help="folder for it (default: build/site)")
    recording = commands.add_parser(
        "record-site", help="run the programs that move the site's robots, and record them"
    )
    recording.add_argument("only", nargs="?", default="", help="a part of a recording's name; all if none")
    commands.add_parser("typings", help="rebuild the message packages' type stubs (workbook/typings)")
    commands.add_parser("robot", help="record the robot, and draw the README's figure again (docs/robot.png)")
    mutating = commands.add_parser("mutants", help="say which small faults of right programs get full marks")
    mutating.add_argument("--only", nargs="+", default=(), metavar="STEM", help="exercises; all if none")
    mutating.add_argument("--most", type=int, default=120, help="mutants that are judged for each exercise")
    mutating.add_argument("--slots", type=int, default=None, help="programs that run at the same time")
    comparing = commands.add_parser("compare", help="run notebooks under nbval and compare their outputs")
    comparing.add_argument("names", nargs="*", metavar="STEM", help="lessons and exercises; all if none")
    comparing.add_argument("--jobs", type=int, default=1, help="notebooks that run at the same time")
    comparing.add_argument("--junit", type=Path, default=None, help="also write a JUnit report to this file")
    return top


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one subcommand. Return the exit code: 0, or 1 if something failed or has to be fixed."""
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
        if options.command == "site":
            from workbook.authoring.site import build_site

            folder = options.out or tree.root / "build" / "site"
            print(f"{build_site(tree, folder)} pages written to {folder}")
            return 0
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
    if options.command == "colab":
        lessons = lessons_for_colab(tree, options.out or tree.root / "build" / "colab", options.package)
        print(f"{len(lessons)} lessons written to {lessons[0].parent}")
        return 0
    if options.command == "record-site":
        from workbook.authoring.site.recordings import record_all

        for recorded in record_all(tree, options.only):
            print(f"recorded   {tree.name(recorded)}")
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
    """Print all violations, then notes on leftover template lines and outdated mutant reports. Return the exit code.

    Notes don't affect the exit code. Without `notes`, print only the number of template lines that are left.
    """
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
            f"{len(left)} lines still come from a template: `make notebooks-check ARGS=--notes` lists them."
        )
    outdated = list(outdated_reports(tree)) if notes else []
    if outdated:
        print(f"\nNotes: {len(outdated)} reports on mutants are out of date.\n{report(outdated)}")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
