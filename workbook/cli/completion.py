"""`workbook completion`: what makes Tab complete commands, options, exercises and topics in a shell."""

import argparse
from typing import Any

from workbook.cli import terminal

PLACES = {
    "bash": "~/.local/share/bash-completion/completions/workbook",
    "zsh": "~/.zfunc/_workbook",
    "fish": "~/.config/fish/completions/workbook.fish",
}
"""Where each shell looks for it. For zsh, `fpath+=~/.zfunc` has to stand before `compinit` in ~/.zshrc."""


def register(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "completion",
        help="let Tab complete commands, exercises and topics in your shell",
        description="Print a script with which Tab completes commands, options, exercises and topics. "
        "Try it with `source <(workbook completion bash)`. To keep it, write it to "
        f"{PLACES['bash']} (zsh: {PLACES['zsh']}, in a folder of your fpath; fish: {PLACES['fish']}).",
    )
    parser.add_argument("shell", metavar="SHELL", choices=tuple(PLACES), help="bash, zsh or fish")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Print the script."""
    from workbook.cli.command_tree import EXERCISES, TOPICS, commands_of
    from workbook.cli.completion_scripts import SHELLS
    from workbook.cli.main import build_parser
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.exercise.source import stems

    try:
        exercises = stems(course_folder() / "solutions")
        words = {EXERCISES: exercises, TOPICS: topics_of(exercises)}
    except NoCourse as error:
        terminal.complain("completion", error)
        return 2
    print(SHELLS[options.shell](list(commands_of(build_parser())), words), end="")
    return 0


def topics_of(exercises: tuple[str, ...]) -> tuple[str, ...]:
    """The topics that the exercises are about, without those that only the judge's drivers use."""
    from workbook.exercise.definition import BrokenCriteria, load_exercise
    from workbook.recording.script import Publishes

    topics: set[str] = set()
    for stem in exercises:
        try:
            plan = load_exercise(stem).plan
        except BrokenCriteria:  # Tab need not know them
            continue
        topics.update(plan.topics)
        topics.update(part.topic for part in plan.script.parts if isinstance(part, Publishes))
    return tuple(sorted(topic for topic in topics if not topic.startswith("/driver/")))
