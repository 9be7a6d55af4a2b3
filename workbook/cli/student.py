"""`workbook student`: list, export, or erase everything that a gradebook contains about one student."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from workbook.cli import terminal

if TYPE_CHECKING:
    from workbook.grading.one_student import Holdings


def register(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand with its actions: list, export, and erase."""
    parser = subparsers.add_parser(
        "student",
        help="list, export, or erase all data about one student in a gradebook",
        description="Find all data about one student in a gradebook: results, logs, recordings, pages, changed marks, "
        "and rows of tables.",
    )
    actions = parser.add_subparsers(title="actions", metavar="ACTION", required=True)
    texts = {
        "list": "list the data; change nothing",
        "export": "pack the data into a zip file",
        "erase": "erase the data, and rewrite the tables and the class page",
    }
    for name, text in texts.items():
        action = actions.add_parser(name, help=text)
        action.add_argument("student", metavar="STUDENT", help="the student's name, as in grades.csv")
        action.add_argument("--out", metavar="DIR", required=True, type=Path, help="the gradebook")
        action.add_argument(
            "--also",
            metavar="CSV",
            action="append",
            default=[],
            type=Path,
            help="one of your lists with students' names: aliases, extensions, appeals. You can repeat this option",
        )
        if name == "export":
            action.add_argument("--to", metavar="FILE.zip", required=True, type=Path, help="a new file")
        action.set_defaults(run=run, action=name)


def run(options: argparse.Namespace) -> int:
    """List, export, or erase the data about the student. Return the exit code.

    The exit code is 2 if the gradebook can't be read or doesn't contain the student, else 0.
    """
    from workbook.grading.one_student import NotErasable, erase, export, holdings
    from workbook.grading.roster import BadOption

    try:
        with holdings(options.out, options.student, options.also) as found:
            _say(found)
            if options.action == "export":
                print(f"Written: {export(found, options.to)}")
            elif options.action == "erase":
                for sentence in erase(found):
                    terminal.say(f"{sentence}.")
                print("Erased. Backups, and copies in other systems, are not touched.")
    except (NotErasable, BadOption, OSError) as error:
        terminal.complain("student", error)
        return 2
    return 0


def _say(found: "Holdings") -> None:
    from workbook.cli.grade_screen import printable

    print(f"In {found.out}, {printable(', '.join(found.names))} has:")
    for one in found.lines:
        lines = "1 line" if len(one.mine) == 1 else f"{len(one.mine)} lines"
        print(f"  {one.path.name}: {lines}")
    for path in found.files:
        print(f"  {path.relative_to(found.out)}")
    for path in found.shared:
        print(f"  {path.relative_to(found.out)}: another student's result needs it, too, so it stays")
    if found.answers:
        terminal.say(
            f"The hand-ins aren't in the gradebook, so they stay: {printable(', '.join(found.answers))}."
        )
