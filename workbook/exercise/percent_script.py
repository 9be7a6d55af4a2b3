"""Read a percent script, a Python file whose cells begin with ``# %% [kind]``. Errors name the line."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

CELL_KINDS = ("markdown", "answer", "live", "hint", "alternatives")

_CELL = re.compile(r"# %%(?:\s+\[(?P<kind>[^\]]*)\])?\s*(?P<more>.*)")

Line = tuple[int, str]
"""A line with its number in the file, from 1."""


class SourceError(ValueError):
    """Raised when an exercise source can't be used. The message begins with ``file:line``."""

    def __init__(self, path: Path | str, line: int, problem: str) -> None:
        super().__init__(f"{path}:{line}: {problem}")
        self.path = Path(path)
        self.line = line
        self.problem = problem


@dataclass(frozen=True)
class SourceCell:
    """One cell: its kind, the line number of its head, and the lines below the head."""

    kind: str
    line: int
    body: tuple[Line, ...]


def cells_of(path: Path, lines: list[Line]) -> list[SourceCell]:
    """Return a percent script's cells. Raises SourceError for an unknown kind, or a line before the first cell."""
    cells: list[SourceCell] = []
    open_kind, open_line, body = "", 0, list[Line]()
    for number, text in lines:
        head = _CELL.fullmatch(text)
        if head is None:
            if not open_kind and text.strip():
                raise SourceError(path, number, "this line stands before the first '# %%' cell")
            body.append((number, text))
            continue
        if open_kind:
            cells.append(SourceCell(open_kind, open_line, tuple(body)))
        if head["kind"] not in CELL_KINDS or head["more"]:
            raise SourceError(
                path,
                number,
                f"unknown cell {text.strip()!r}: there are {', '.join(f'# %% [{k}]' for k in CELL_KINDS)}",
            )
        open_kind, open_line, body = head["kind"], number, []
    if open_kind:
        cells.append(SourceCell(open_kind, open_line, tuple(body)))
    return cells


def trimmed(body: Sequence[Line]) -> list[Line]:
    """Return the lines without blank ones at the beginning and end."""
    kept = list(body)
    while kept and not kept[0][1].strip():
        kept.pop(0)
    while kept and not kept[-1][1].strip():
        kept.pop()
    return kept


def uncommented(path: Path, cell: SourceCell) -> str:
    """Return the content of a commented-out cell. Raises SourceError for a line that isn't a comment."""
    lines = []
    for number, text in trimmed(cell.body):
        if text.strip() and not text.startswith("#"):
            raise SourceError(path, number, f"each line of a [{cell.kind}] cell must begin with '# '")
        lines.append(text[2:] if text.startswith("# ") else text[1:])
    return "\n".join(lines).strip("\n")


def markdown(path: Path, cell: SourceCell) -> str:
    """Return the content of a commented-out cell. Raises SourceError if the cell is empty or not commented out."""
    text = uncommented(path, cell)
    if not text.strip():
        raise SourceError(path, cell.line, f"this [{cell.kind}] cell is empty")
    return text
