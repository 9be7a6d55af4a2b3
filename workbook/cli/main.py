"""The `workbook` command: finds the subcommands and runs one.

Every module of this package with a `register(subparsers)` function adds its subcommands; it sets the default
`run` of its parser to a function that takes the parsed arguments and returns the exit code. Such modules import
nothing heavy at their top, so that `workbook --help` answers at once.
"""

import argparse
import atexit
import importlib
import os
import pkgutil
import sys
from collections.abc import Sequence
from typing import NoReturn

import workbook
from workbook import cli


def build_parser() -> argparse.ArgumentParser:
    """The parser with the subcommands of every module of `workbook.cli`."""
    parser = argparse.ArgumentParser(
        prog="workbook",
        allow_abbrev=False,
        description="Learn ROS 2 with rclpy: lessons, exercises, and a judge that watches the robot.",
    )
    parser.add_argument("--version", action="version", version=f"workbook {workbook.__version__}")
    subparsers = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for module in sorted(pkgutil.iter_modules(cli.__path__), key=lambda found: found.name):
        register = getattr(importlib.import_module(f"{cli.__name__}.{module.name}"), "register", None)
        if register is not None:
            register(subparsers)
    return parser


def drop_search_path() -> None:
    """Start again without PYTHONPATH: a sourced ROS would put its own rclpy before that of the wheels."""
    if not (os.environ.get("PYTHONPATH") or os.environ.get("PYTHONHOME")):
        return
    from workbook.ros.environment import uses_wheels

    if uses_wheels():
        environ = {
            name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONHOME")
        }
        os.execve(sys.executable, [sys.executable, "-P", "-m", "workbook.cli.main", *sys.argv[1:]], environ)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one subcommand and return its exit code."""
    if arguments is None:
        drop_search_path()
    parser = build_parser()
    options, rest = parser.parse_known_args(arguments)
    if rest:
        if not getattr(options, "takes_rest", False):
            parser.error(f"unknown arguments: {' '.join(rest)}")
        options.rest = rest
    else:
        options.rest = []
    try:
        code: int = options.run(options)
    except KeyboardInterrupt:
        print("\nStopped.", file=sys.stderr)
        return 130
    except BrokenPipeError:
        sys.stderr.close()
        return 0
    if arguments is None and getattr(options, "leaves_at_once", False):
        leave(code)
    return code


def leave(code: int) -> NoReturn:
    """Run the exit functions, then end the process without the interpreter's own shutdown.

    With rclpy and NumPy loaded that shutdown takes 0.1 s, which a student would wait for after each check.
    """
    atexit._run_exitfuncs()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


if __name__ == "__main__":
    sys.exit(main())
