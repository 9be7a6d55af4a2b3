"""`workbook hint`: print an exercise's next hint in the terminal, as `%hint` does in a notebook."""

import argparse
import re
from typing import Any

from workbook.cli import terminal

LEVELS = ("nudge", "pointer", "sketch")
_FENCE = "```"
_LINK = re.compile(r"\[([^\]]+)\]\(([^)]+)\)")
_ENTRY = re.compile(r"\n(?=\s*(?:-|\d+\.) )")


def register(subparsers: Any) -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "hint",
        help="show the next of an exercise's three hints: a nudge, a pointer, a sketch",
        description="Show the next hint for an exercise. With LEVEL, show that hint and the ones before it.",
    )
    parser.add_argument("exercise", metavar="EXERCISE", help="such as 09 or joint_positions")
    parser.add_argument(
        "level",
        metavar="LEVEL",
        nargs="?",
        help="1 or nudge, 2 or pointer, 3 or sketch (default: the next hint)",
    )
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Print the hints, and record in the student's progress how many were shown. Return the exit code."""
    from workbook.cli.paths import student_answers
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.exercise.source import SourceError, UnknownExercise, find, load

    try:
        source = load(find(course_folder() / "solutions", options.exercise))
        level = _level(options.level)
        student_answers()
        print(hints_of(source.stem, source.hints, level))
    except BrokenPipeError:
        raise
    except (UnknownExercise, NoCourse, SourceError, ValueError, OSError) as error:
        terminal.complain("hint", error)
        return 2
    return 0


def _level(text: str | None) -> int | None:
    """Return a hint's number, counted from 1, or None for the next hint. Raises ValueError if there is no such hint."""
    if text is None:
        return None
    if text in LEVELS:
        return LEVELS.index(text) + 1
    if text.isdigit() and 1 <= int(text) <= len(LEVELS):
        return int(text)
    raise ValueError(f"there is no hint {text}. The hints are 1 (nudge), 2 (pointer), and 3 (sketch)")


def hints_of(stem: str, hints: tuple[str, ...], level: int | None) -> str:
    """Return the hints up to `level` as text, and record in the student's progress how many were shown.

    If `level` is None, return one more hint than before.
    """
    from workbook.lesson.progress import changed_progress

    with changed_progress(stem) as progress:
        upto = min(progress.hints + 1, len(hints)) if level is None else level
        progress.hints = max(progress.hints, upto)
    shown = [
        f"Hint {number} of {len(hints)}, a {name}\n\n{as_terminal_text(text)}"
        for number, name, text in list(zip(range(1, upto + 1), LEVELS, hints, strict=False))
    ]
    left = len(hints) - upto
    more = f"`workbook hint {stem[:2]}` shows more." if left else "That was the last hint."
    return "\n\n".join([*shown, terminal.wrapped(more)])


def as_terminal_text(markdown: str) -> str:
    """Format Markdown for a terminal: wrap the prose, and indent code blocks without wrapping them."""
    lines: list[str] = []
    for number, part in enumerate(markdown.split(_FENCE)):
        if number % 2:  # a code block, whose first line names the language
            lines += [f"    {line}".rstrip() for line in part.split("\n")[1:-1]]
        else:
            lines += [_prose(block) for block in re.split(r"\n\s*\n", part.strip()) if block]
        lines.append("")
    return re.sub(r"\n{3,}", "\n\n", "\n".join(lines)).strip("\n")


def _prose(block: str) -> str:
    """Wrap a paragraph or a list. Each list item begins on a new line, and a link's target follows its text."""
    block = _LINK.sub(r"\1 (\2)", block).replace("**", "")
    entries = [" ".join(entry.split()) for entry in _ENTRY.split(block)]
    return "\n".join(
        f"- {terminal.wrapped(entry[2:], '  ')[2:]}" if entry.startswith("- ") else terminal.wrapped(entry)
        for entry in entries
    )
