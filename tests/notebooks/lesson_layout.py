"""Check a notebook's layout: no code lines wider than its column, and no headings that skip a level."""

import re
from pathlib import Path

import jupytext

ROOT = Path(__file__).resolve().parents[2]
WIDEST_CODE = 88
"""Characters that fit next to the file browser at 1280 pixels."""
SOURCES = sorted((ROOT / "notebooks" / "sources").glob("[0-9]*.py"))
_FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
_HEADING = re.compile(r"^(#{1,6}) +(.+)", re.MULTILINE)


def wide_lines(cells: list[tuple[str, str]]) -> list[str]:
    """Return the lines of code, in code cells and in the text, that are wider than a notebook's column."""
    code = [source for kind, source in cells if kind == "code"]
    code += [block for kind, source in cells if kind == "markdown" for block in _FENCE.findall(source)]
    return [line for text in code for line in text.splitlines() if len(line) > WIDEST_CODE]


def skipped_headings(cells: list[tuple[str, str]]) -> list[str]:
    """Return the headings that are more than one level below the preceding heading."""
    found, last = [], 0
    for kind, source in cells:
        if kind == "markdown":
            for signs, text in _HEADING.findall(_FENCE.sub("", source)):
                if len(signs) > last + 1:
                    found.append(text)
                last = len(signs)
    return found


def cells_of(path: Path) -> list[tuple[str, str]]:
    """Return the kind and text of each cell of a percent script."""
    return [(cell.cell_type, cell.source) for cell in jupytext.read(path, fmt="py:percent").cells]


CHECKS = {"wide_lines": wide_lines, "skipped_headings": skipped_headings}
