"""Notebooks before they run: cells with fixed IDs, and the minimal metadata that Jupyter requires."""

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Literal

import nbformat

from workbook.lab.jupyter_files import kernel_spec
from workbook.lesson.prediction import Prediction

KERNEL = {"display_name": kernel_spec("python")["display_name"], "language": "python", "name": "python3"}
LANGUAGE = {
    "codemirror_mode": {"name": "ipython", "version": 3},
    "file_extension": ".py",
    "mimetype": "text/x-python",
    "name": "python",
    "nbconvert_exporter": "python",
    "pygments_lexer": "ipython3",
}
OPENING = "intro"
_HEADING = re.compile(r"## +(?P<title>.+?)\s*#*")
_ID = re.compile(r"[a-zA-Z0-9_-]{1,64}")

Kind = Literal["markdown", "code"]
Notebook = nbformat.NotebookNode


@dataclass(frozen=True)
class Cell:
    """A cell without outputs. If the ID is empty, `with_ids` derives one from the cell's position."""

    kind: Kind
    source: str
    id: str = ""
    tags: tuple[str, ...] = ()
    line: int = field(default=0, compare=False)
    """The cell's first line in the text, counted from 1, or 0 if the cell doesn't come from a text."""


@dataclass(frozen=True)
class Document:
    """Everything that a notebook's text determines. `workbook` is our part of the notebook's metadata.

    `predictions` contains the answers and explanations, which are in the text but not in the notebook.
    """

    cells: tuple[Cell, ...]
    workbook: dict[str, Any] = field(default_factory=dict)
    predictions: tuple[Prediction, ...] = ()


def heading_of(cell: Cell) -> str | None:
    """Return the text of the `## ` heading at the beginning of a Markdown cell, or None if there is none."""
    if cell.kind != "markdown":
        return None
    found = _HEADING.fullmatch(cell.source.split("\n", 1)[0])
    return found["title"] if found else None


def with_ids(cells: Sequence[Cell]) -> tuple[Cell, ...]:
    """Give each cell without an ID an ID made of its section and its position in that section, such as `run-it-2`.

    With such IDs, adding a cell changes only the IDs in its section. Raises ValueError for an invalid or repeated ID.
    """
    named: list[Cell] = []
    section = OPENING
    counts: Counter[str] = Counter()
    for cell in cells:
        heading = heading_of(cell)
        if heading is not None:
            section = re.sub(r"[^a-z0-9]+", "-", heading.lower()).strip("-")[:50] or "section"
        counts[section] += 1
        named.append(cell if cell.id else replace(cell, id=f"{section}-{counts[section]}"))
    for cell in named:
        if not _ID.fullmatch(cell.id):
            raise ValueError(f"the cell id {cell.id!r} may have letters, digits, - and _ only, at most 64")
    twice = [name for name, times in Counter(cell.id for cell in named).items() if times > 1]
    if twice:
        raise ValueError(f"the cell id {twice[0]!r} is used twice: give one of the cells another id")
    return tuple(named)


def as_notebook(document: Document) -> Notebook:
    """Return the document as a notebook without outputs."""
    cells = []
    for cell in document.cells:
        extra = {"tags": list(cell.tags)} if cell.tags else {}
        if cell.kind == "markdown":
            made = nbformat.v4.new_markdown_cell(cell.source, id=cell.id, metadata=extra)
        else:
            made = nbformat.v4.new_code_cell(cell.source, id=cell.id, metadata=extra)
        cells.append(made)
    metadata = {"kernelspec": KERNEL, "language_info": LANGUAGE, "workbook": document.workbook}
    notebook: Notebook = nbformat.v4.new_notebook(cells=cells, metadata=metadata)
    notebook.nbformat_minor = 5
    return notebook


def to_text(notebook: Notebook) -> str:
    """Serialize a notebook. The same content always gives the same text."""
    nbformat.validate(notebook)
    return str(nbformat.writes(notebook, version=4)).rstrip("\n") + "\n"


def read(path: Path) -> Notebook:
    """Read a notebook file. Raises ValueError if the file isn't a notebook."""
    try:
        notebook: Notebook = nbformat.read(path, as_version=4)
    except Exception as error:
        raise ValueError(f"is not a readable notebook: {error}") from error
    return notebook


def without_outputs(notebook: Notebook) -> Notebook:
    """Return a copy without outputs and execution counts."""
    bare: Notebook = nbformat.reads(nbformat.writes(notebook, version=4), as_version=4)
    for cell in bare.cells:
        if cell.cell_type == "code":
            cell.outputs, cell.execution_count = [], None
    return bare


def write(path: Path, text: str) -> bool:
    """Write the text to a file unless the file already contains it. Return whether the file was written."""
    if path.is_file() and path.read_text(encoding="utf-8") == text:
        return False
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")
    return True
