"""Violations that checks find: a file, a line, and a message for the author."""

import re
from collections.abc import Iterable
from dataclasses import dataclass


@dataclass(frozen=True)
class Violation:
    """A broken rule in the file `where` (relative to the course). `line` counts from 1; 0 means the whole file."""

    where: str
    words: str
    line: int = 0

    def __str__(self) -> str:
        place = f"{self.where}:{self.line}" if self.line else self.where
        return f"{place}: {self.words}"


def report(found: Iterable[Violation]) -> str:
    """Return the violations as `file:line: words`, one per line, grouped by file."""
    order: dict[str, list[Violation]] = {}
    for one in found:
        order.setdefault(one.where, []).append(one)
    return "\n".join(str(one) for ones in order.values() for one in ones)


def line_of(text: str, pattern: str) -> int:
    """Return the number of the first line that matches the pattern, or 1 if none does."""
    for number, line in enumerate(text.splitlines(), start=1):
        if re.search(pattern, line):
            return number
    return 1
