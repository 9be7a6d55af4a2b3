"""Terminal helpers that all commands share: width, colors, wrapping, and suggestions for misspelled names."""

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
    """Return the number of columns that a line may use: the terminal's width, but at least 40 and at most 80."""
    return max(NARROWEST, min(WIDEST, shutil.get_terminal_size().columns))


def in_color(stream: TextIO) -> bool:
    """Return whether to print colors to a stream: only if it's a terminal and NO_COLOR isn't set."""
    return stream.isatty() and "NO_COLOR" not in os.environ


def wrapped(text: str, indent: str = "", columns: int | None = None) -> str:
    """Wrap each line of `text`. Code between backticks isn't split if it fits on one line."""
    return "\n".join(
        _wrapped_line(line, indent, width() if columns is None else columns) for line in text.split("\n")
    )


def _wrapped_line(line: str, indent: str, columns: int) -> str:
    parts = line.split("`")
    if len(parts) % 2:  # the backticks are balanced
        room = columns - len(indent) - 3  # for two backticks and a punctuation mark
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
    """Print `text`, wrapped to the terminal's width.

    If the output goes to a file or a pipe, don't wrap it unless COLUMNS is set.
    """
    stream = stream or sys.stdout
    fits = stream.isatty() or "COLUMNS" in os.environ
    print(wrapped(text) if fits else text, file=stream, flush=True)


def complain(command: str, problem: object) -> None:
    """Print a problem to standard error, prefixed with the name of the command."""
    say(f"workbook {command}: {problem}", sys.stderr)


def meant(word: str, known: Iterable[str], cutoff: float = 0.6) -> str:
    """Return a question that suggests the name that was probably meant, or "" if no known name is similar."""
    near = difflib.get_close_matches(word, list(known), n=1, cutoff=cutoff)
    return f"Did you mean {near[0]}?" if near else ""
