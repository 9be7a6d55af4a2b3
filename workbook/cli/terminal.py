"""What all commands share in a terminal: how wide a line may be, colors, sentences that wrap, likely meanings."""

import difflib
import os
import shutil
import sys
import textwrap
from collections.abc import Iterable
from typing import TextIO

WIDEST = 80
NARROWEST = 40
_CODE_SPACE = "\xa0"


def width() -> int:
    """The columns that a line may take: those of the terminal, 80 at most."""
    return max(NARROWEST, min(WIDEST, shutil.get_terminal_size().columns))


def in_color(stream: TextIO) -> bool:
    """Whether to print colors there."""
    return stream.isatty() and "NO_COLOR" not in os.environ


def wrapped(text: str, indent: str = "", columns: int | None = None) -> str:
    """Each line of a text, broken to fit. What stands between backticks stays together if it fits on a line."""
    return "\n".join(
        _wrapped_line(line, indent, width() if columns is None else columns) for line in text.split("\n")
    )


def _wrapped_line(line: str, indent: str, columns: int) -> str:
    parts = line.split("`")
    if len(parts) % 2:  # every backtick has its partner
        room = columns - len(indent) - 3  # two backticks, and a sign that follows
        parts[1::2] = [part.replace(" ", _CODE_SPACE) if len(part) <= room else part for part in parts[1::2]]
    broken = textwrap.fill(
        "`".join(parts),
        columns,
        initial_indent=indent,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    )
    return broken.replace(_CODE_SPACE, " ")


def say(text: str, stream: TextIO | None = None) -> None:
    """Print sentences so that they fit. In a file or a pipe, lines are not broken."""
    stream = stream or sys.stdout
    fits = stream.isatty() or "COLUMNS" in os.environ
    print(wrapped(text) if fits else text, file=stream, flush=True)


def complain(command: str, problem: object) -> None:
    """Say on standard error what is wrong, after the command that says it."""
    say(f"workbook {command}: {problem}", sys.stderr)


def meant(word: str, known: Iterable[str], cutoff: float = 0.6) -> str:
    """A question for the name that was probably meant; empty when none is similar."""
    near = difflib.get_close_matches(word, list(known), n=1, cutoff=cutoff)
    return f"Did you mean {near[0]}?" if near else ""
