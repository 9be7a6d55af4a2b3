"""`workbook doctor`: check whether this machine is ready, and say what to do if it isn't."""

import argparse
import os
import sys
from typing import TYPE_CHECKING, Any, TextIO

from workbook.cli import terminal

if TYPE_CHECKING:
    from workbook.lab.health import HealthFinding

SIGNS = {"ok": "✓", "note": "!", "fix": "✗"}
PLAIN_SIGNS = {"ok": "+", "note": "!", "fix": "x"}
_COLUMN = 23
COLORS = {"ok": "32", "note": "33", "fix": "31"}


def register(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "doctor",
        help="check whether this machine is ready, and say how to fix problems",
        description="Check Python, packages, ROS, folders, and Jupyter, and let two processes exchange messages. Exit "
        "code 0: ready, 1: something must be fixed.",
    )
    parser.add_argument(
        "--report",
        action="store_true",
        help="print a report for an issue: versions and findings, without home folders, user name, and machine name",
    )
    parser.set_defaults(run=run)


def line(finding: "HealthFinding", stream: TextIO) -> str:
    """Format a finding: a sign, its status, its title, the observation, and, on a new line, the next step.

    Color the status on a terminal. Use ASCII signs if the stream's encoding lacks ✓ and ✗.
    """
    try:
        "✓✗".encode(stream.encoding or "ascii")
        sign = SIGNS[finding.status]
    except UnicodeEncodeError:
        sign = PLAIN_SIGNS[finding.status]
    mark = f"{sign} {finding.status:<5}"
    if stream.isatty() and "NO_COLOR" not in os.environ:
        mark = f"\033[{COLORS[finding.status]}m{mark}\033[0m"
    arrow = "→" if sign in SIGNS.values() else ">"
    lines = [f"{mark}{finding.title:<15} {_in_column(finding.saw)[_COLUMN:]}"]
    if finding.todo:
        lines.append(_in_column(f"{arrow} {finding.todo}"))
    return "\n".join(lines)


def _in_column(text: str) -> str:
    return terminal.wrapped(text, " " * _COLUMN, max(terminal.width(), 2 * _COLUMN))


def report() -> str:
    """Return the versions and findings as plain text without personal names, so that users can publish the report."""
    from workbook.cli.report import doctor_lines
    from workbook.exercise.course import is_from_wheel
    from workbook.grading.new_results import versions
    from workbook.lesson.help_report import without_names

    made = versions("")
    source = "wheel" if is_from_wheel() else "clone"
    first = f"rclpy-workbook {made.workbook} ({source}), rclpy {made.rclpy}, Python {made.python}"
    return "\n".join([first, *(without_names(one) for one in doctor_lines())])


def run(options: argparse.Namespace) -> int:
    """Print each finding right away, and then a summary. Return the exit code: 1 if something must be fixed, else 0."""
    from workbook.exercise.course import is_from_wheel
    from workbook.lab.health import examine

    if options.report:
        print(report())
        return 0
    to_fix = 0
    for finding in examine():
        to_fix += finding.status == "fix"
        print(line(finding, sys.stdout), flush=True)
    if to_fix:
        print(f"\n{to_fix} to fix. Start with the first.")
        return 1
    print(f"\nReady. `{'rclpy-workbook lab' if is_from_wheel() else 'make lab'}` opens the lessons.")
    return 0
