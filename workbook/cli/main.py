"""Run the `workbook` command: find the subcommands, and run one of them.

Each module of this package with a `register(subparsers)` function adds its subcommands. `register` sets the parser's
default `run` to a function that takes the parsed arguments and returns the exit code. To keep `workbook --help` fast,
these modules don't import slow modules at the top.
"""

import atexit
import importlib
import io
import os
import pkgutil
import sys
from collections.abc import Sequence
from typing import NoReturn

import workbook
from workbook import cli
from workbook.cli.completion import answer_tab
from workbook.cli.parsing import CommandParser, show_what_is_below

GROUPS = (
    ("Lessons and exercises", ("lab", "check", "hint", "progress", "restore", "reset", "report")),
    ("The robot of the open notebook", ("node", "topic", "graph")),
    ("This machine", ("doctor", "completion")),
    ("For instructors and authors", ("grade", "student", "replay", "package", "new")),
    ("Called by other systems", ("autograde",)),
)


def build_parser() -> CommandParser:
    """Return the parser with the subcommands of every module of `workbook.cli`."""
    parser = CommandParser(
        prog="workbook",
        groups=GROUPS,
        allow_abbrev=False,
        description="Learn ROS 2 with rclpy: lessons, exercises, and a judge that watches the robot.",
    )
    parser.add_argument("--version", action="version", version=f"workbook {workbook.__version__}")
    subparsers = parser.add_subparsers(title="commands", metavar="COMMAND")
    for module in sorted(pkgutil.iter_modules(cli.__path__), key=lambda found: found.name):
        register = getattr(importlib.import_module(f"{cli.__name__}.{module.name}"), "register", None)
        if register is not None:
            register(subparsers)
    return parser


def drop_search_path() -> None:
    """Restart without PYTHONPATH and PYTHONHOME if rclpy is installed from wheels.

    Otherwise, after sourcing a ROS installation, Python would import that installation's rclpy.
    """
    if not (os.environ.get("PYTHONPATH") or os.environ.get("PYTHONHOME")):
        return
    from workbook.ros.environment import uses_wheels

    if uses_wheels():
        environ = {
            name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONHOME")
        }
        os.execve(sys.executable, [sys.executable, "-P", "-m", "workbook.cli.main", *sys.argv[1:]], environ)


def print_any_text() -> None:
    """Make printing replace characters that the terminal can't encode with question marks instead of raising errors."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one subcommand, and return its exit code."""
    if arguments is None:
        drop_search_path()
        answer_tab(build_parser)
        print_any_text()
    words = list(sys.argv[1:] if arguments is None else arguments)
    if words[:1] == ["help"]:
        words = [*words[1:], "--help"]
    try:
        return _run(words, may_leave=arguments is None)
    except KeyboardInterrupt:
        print("\nStopped.", file=sys.stderr)
        return 130
    except BrokenPipeError:  # the reading process has exited, as in `workbook check 09 | head -1`
        sys.stderr.close()
        return 0


def _run(words: Sequence[str], *, may_leave: bool) -> int:
    options, rest = build_parser().parse_known_args(words)
    options.rest = rest
    command: CommandParser = options.command
    if rest and not getattr(options, "takes_rest", False):
        command.refuse(rest)
    if command.below:
        return show_what_is_below(command)
    code: int = options.run(options)
    if may_leave and getattr(options, "leaves_at_once", False):
        leave(code)
    return code


def leave(code: int) -> NoReturn:
    """Run the exit functions, and then exit without the interpreter's own shutdown.

    With rclpy and NumPy loaded, the shutdown takes 0.1 s, for which students would have to wait after each check.
    """
    atexit._run_exitfuncs()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


if __name__ == "__main__":
    sys.exit(main())
