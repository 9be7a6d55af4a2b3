"""`workbook completion`: print a script that makes a shell complete commands, options, exercises, and topics on Tab.

The script comes from argcomplete. When the user presses Tab, the script calls `workbook`, and `answer_tab` writes the
completions. So the script doesn't have to change when a command does.
"""

import argparse
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from workbook.cli.parsing import CommandParser

PLACES = {
    "bash": "~/.local/share/bash-completion/completions/workbook",
    "zsh": "~/.zfunc/_workbook",
    "fish": "~/.config/fish/completions/workbook.fish",
}
"""Where each shell looks for the script. For zsh, `fpath+=~/.zfunc` must come before `compinit` in ~/.zshrc."""


def register(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "completion",
        help="let Tab complete commands, exercises, and topics in your shell",
        description="Print a script that lets Tab complete commands, options, exercises, and topics. Try it with "
        f"`source <(workbook completion bash)`. To keep it, write it to {PLACES['bash']} (zsh: {PLACES['zsh']}, in a "
        f"folder of your fpath; fish: {PLACES['fish']}).",
    )
    parser.add_argument("shell", metavar="SHELL", choices=tuple(PLACES), help="bash, zsh, or fish")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Print the shell's completion script. Return the exit code."""
    from argcomplete.shell_integration import shellcode

    print(shellcode(["workbook", "rclpy-workbook"], shell=options.shell))
    return 0


def answer_tab(build_parser: Callable[[], CommandParser]) -> None:
    """Write the completions and exit if a completion script called `workbook`. Otherwise, do nothing."""
    if "_ARGCOMPLETE" not in os.environ:
        return
    import argcomplete
    from argcomplete.completers import FilesCompleter, SuppressCompleter

    parser = build_parser()
    completers = {"EXERCISE": _exercises, "ID": _exercises, "TOPIC": _topics}
    for action in _arguments_of(parser):
        completer: Any = FilesCompleter() if action.type is Path else completers.get(str(action.metavar))
        if completer is not None:
            setattr(action, "completer", completer)  # noqa: B010 (argparse lacks this attribute; argcomplete reads it)
    argcomplete.autocomplete(parser, always_complete_options=False, default_completer=SuppressCompleter())


def _arguments_of(parser: CommandParser) -> Iterator[argparse.Action]:
    yield from parser.arguments
    for below in parser.below.values():
        yield from _arguments_of(below)


def _exercises(**_: object) -> tuple[str, ...]:
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.exercise.source import stems

    try:
        return stems(course_folder() / "solutions")
    except NoCourse:
        return ()


def _topics(**_: object) -> tuple[str, ...]:
    """Return the topics of all exercises, except those that only the judge's drivers use.

    A driver is a program that imports an answer and calls its functions.
    """
    from workbook.exercise.definition import BrokenCriteria, load_exercise
    from workbook.recording.script import Publishes

    topics: set[str] = set()
    for stem in _exercises():
        try:
            plan = load_exercise(stem).plan
        except BrokenCriteria:  # completion works without this exercise's topics
            continue
        topics.update(plan.topics)
        topics.update(part.topic for part in plan.script.parts if isinstance(part, Publishes))
    return tuple(sorted(topic for topic in topics if not topic.startswith("/driver/")))
