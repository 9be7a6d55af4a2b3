"""What a notebook does to the eye: code lines that are too wide for its column, headings that skip a level.

`python -m tests.notebooks.lesson_layout` writes the exceptions that are left; they may only become fewer.
"""

import re
import tomllib
from collections import Counter
from pathlib import Path

import jupytext

ROOT = Path(__file__).resolve().parents[2]
KEPT = Path(__file__).with_name("lesson_layout.toml")
COMMAND = "python -m tests.notebooks.lesson_layout"
WIDEST_CODE = 88
"""Characters that fit beside the column of files at 1280 pixels."""
SOURCES = sorted((ROOT / "notebooks" / "sources").glob("[0-9]*.py"))
_FENCE = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
_HEADING = re.compile(r"^(#{1,6}) +(.+)", re.MULTILINE)


def wide_lines(cells: list[tuple[str, str]]) -> list[str]:
    """Lines of code, in code cells and in the text, that are wider than a notebook's column."""
    code = [source for kind, source in cells if kind == "code"]
    code += [block for kind, source in cells if kind == "markdown" for block in _FENCE.findall(source)]
    return [line for text in code for line in text.splitlines() if len(line) > WIDEST_CODE]


def skipped_headings(cells: list[tuple[str, str]]) -> list[str]:
    """Headings that are more than one level below the heading before."""
    found, last = [], 0
    for kind, source in cells:
        if kind == "markdown":
            for signs, text in _HEADING.findall(_FENCE.sub("", source)):
                if len(signs) > last + 1:
                    found.append(text)
                last = len(signs)
    return found


def cells_of(path: Path) -> list[tuple[str, str]]:
    """Kind and text of each cell of a percent script."""
    return [(cell.cell_type, cell.source) for cell in jupytext.read(path, fmt="py:percent").cells]


CHECKS = {"wide_lines": wide_lines, "skipped_headings": skipped_headings}


def count() -> dict[str, Counter[str]]:
    """For each check and each lesson, how often it fails."""
    cells = {path.stem: cells_of(path) for path in SOURCES}
    return {
        name: +Counter({stem: len(check(found)) for stem, found in cells.items()})
        for name, check in CHECKS.items()
    }


def kept() -> dict[str, dict[str, int]]:
    """The counts that are allowed, by check and lesson."""
    return tomllib.loads(KEPT.read_text(encoding="utf-8")) if KEPT.is_file() else {}


def main() -> None:
    """Write the counts that have become smaller; those of a new check as they are."""
    old, lines = kept(), [f"# What is left, by lesson; may only shrink. Written by `{COMMAND}`."]
    for name, now in count().items():
        lines += ["", f"[{name}]"]
        fewer = {
            stem: min(n, old[name].get(stem, 0)) if name in old else n for stem, n in sorted(now.items())
        }
        lines += [f'"{stem}" = {n}' for stem, n in fewer.items() if n]
    KEPT.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(f"Written: {KEPT.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
