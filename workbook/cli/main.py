"""The `workbook` command: finds the subcommands and runs one.

Every module of this package with a `register(subparsers)` function adds its subcommands; it sets the default
`run` of its parser to a function that takes the parsed arguments and returns the exit code. Such modules import
nothing heavy at their top, so that `workbook --help` answers at once.
"""

import argparse
import importlib
import pkgutil
import sys
from collections.abc import Sequence

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


def main(arguments: Sequence[str] | None = None) -> int:
    """Run one subcommand and return its exit code."""
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
    return code


if __name__ == "__main__":
    sys.exit(main())
