"""Split an answer with marked parts into the solution and the starter: ``[solution]``, ``[starter]``, ``[end]``."""

import re
from collections.abc import Sequence
from pathlib import Path

from workbook.exercise.percent_script import Line, SourceError

_MARKER = re.compile(r"\s*#\s*\[(?P<name>[a-z]+)\]\s*")
_STARTER_LINE = re.compile(r"(?P<indent>\s*)# \|(?: (?P<text>.*))?")


def split_answer(lines: Sequence[Line], path: Path | str = "answer") -> tuple[list[Line], list[Line]]:
    """Split an answer's numbered lines into the solution's and the starter's.

    Lines outside marked parts go to both, unchanged. Raises SourceError for markers that are out of order, unclosed, or
    misspelled, and for a starter line without ``# |``.
    """
    solution: list[Line] = []
    starter: list[Line] = []
    state, opened = "outside", 0
    for number, text in lines:
        marker = _MARKER.fullmatch(text)
        if marker is not None:
            name = marker["name"]
            problem = _out_of_order(name, state, opened)
            if problem:
                raise SourceError(path, number, problem)
            if name == "solution":
                opened = number
            state = "outside" if name == "end" else name
            continue
        if state in ("outside", "solution"):
            solution.append((number, text))
        if state == "outside":
            starter.append((number, text))
        elif state == "starter":
            starter.append((number, _starter_line(text, number, path)))
    if state != "outside":
        raise SourceError(path, opened, "this [solution] has no [end]")
    return solution, starter


def _out_of_order(marker: str, state: str, opened: int) -> str:
    """Return the problem with a marker at this place, or "" if there is none.

    `opened`: the line of the [solution] marker that's still open.
    """
    if marker not in ("solution", "starter", "end"):
        return f"unknown marker [{marker}]: there are [solution], [starter] and [end]"
    if marker == "solution" and state != "outside":
        return f"[solution] inside the part that line {opened} opened: write [end] first"
    if marker == "starter" and state != "solution":
        return "[starter] without a [solution] before it"
    if marker == "end" and state == "outside":
        return "[end] without a [solution] before it"
    return ""


def _starter_line(text: str, number: int, path: Path | str) -> str:
    line = _STARTER_LINE.fullmatch(text)
    if line is None:
        raise SourceError(path, number, "a starter line must look like '# | code' (or '# |' when empty)")
    code = line["text"] or ""
    return line["indent"] + code if code else ""
