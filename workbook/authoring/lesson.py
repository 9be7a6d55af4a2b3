"""Read a lesson's text, `notebooks/sources/NN_slug.py`, which is a jupytext percent script."""

import hashlib
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import jupytext

from workbook.authoring.document import Cell, Document, with_ids
from workbook.authoring.plain_helpers import with_plain_helpers
from workbook.authoring.predictions import read_prediction
from workbook.authoring.tree import AuthoringError, Tree
from workbook.lesson.prediction import Prediction
from workbook.lesson.sealed_predictions import seal

FORMAT = "1"
"""Increase this number when the builder's outputs change for the same text. Then every lesson runs again."""
TAGS = ("raises-exception", "nbval-ignore-output")
_NODE = re.compile(r"\blesson_nodes(?:[./]|\s+import\s+\(?\s*)(?P<names>[a-z_][\w, \n]*)")


def read_lesson(tree: Tree, stem: str) -> Document:
    """Return the notebook that a lesson's text describes.

    Raises AuthoringError if the text contains a kind of cell, a tag, or anything else that lessons may not use.
    """
    path = tree.sources / f"{stem}.py"
    text = path.read_text(encoding="utf-8")
    shown = tree.name(path)
    cells = []
    predictions: list[Prediction] = []
    lines = [place for place, line in enumerate(text.splitlines(), start=1) if re.match(r"# %%(\s|$)", line)]
    for number, read in enumerate(jupytext.reads(text, fmt="py:percent").cells, start=1):
        metadata = dict(read.metadata)
        metadata.pop("lines_to_next_cell", None)
        identifier = str(metadata.pop("id", ""))
        tags = metadata.pop("tags", [])
        asked = metadata.pop("prediction", None)
        where = f"{shown}, cell {number} ({_first_line(read.source)})"
        _refuse_unknown(read.cell_type, read.source, metadata, tags, where)
        line = lines[number - 1] if number <= len(lines) else 0
        source = read.source
        if read.cell_type == "markdown":
            source = with_plain_helpers(source, where)
        if asked is not None:
            try:
                source, prediction = read_prediction(str(asked), source)
            except ValueError as error:
                raise AuthoringError(f"{where}: {error}") from error
            predictions.append(prediction)
        cells.append(Cell(read.cell_type, source, identifier, tuple(tags), line))
    try:
        named = with_ids(cells)
    except ValueError as error:
        raise AuthoringError(f"{shown}: {error}") from error
    return Document(named, _metadata(tree, stem, text, named, predictions), tuple(predictions))


def _refuse_unknown(kind: str, source: str, metadata: dict[str, object], tags: list[str], where: str) -> None:
    """Raise AuthoringError for an empty cell, or for an unknown kind, tag, or metadata field.

    `metadata` contains the fields that remain after removing the known ones.
    """
    if kind not in ("markdown", "code"):
        raise AuthoringError(f"{where}: a lesson has markdown and code cells, not {kind} cells")
    if metadata:
        raise AuthoringError(
            f"{where}: only id, tags and prediction may be set, not {', '.join(sorted(metadata))}"
        )
    unknown = [tag for tag in tags if tag not in TAGS]
    if unknown:
        raise AuthoringError(f"{where}: unknown tag {unknown[0]!r}; lessons use {' and '.join(TAGS)}")
    if not source.strip():
        raise AuthoringError(f"{where}: this cell is empty")


def inputs(tree: Tree, text: str) -> tuple[Path, ...]:
    """Return the paths of the `lesson_nodes` modules that the text names, directly or through other such modules."""
    found: set[Path] = set()
    waiting = [text]
    while waiting:
        for match in _NODE.finditer(waiting.pop()):
            for name in re.findall(r"\w+", match["names"]):
                path = tree.lesson_nodes / f"{name}.py"
                if path.is_file() and path not in found:
                    found.add(path)
                    waiting.append(path.read_text(encoding="utf-8"))
    return tuple(sorted(found))


def source_sha256(tree: Tree, text: str, cells: Sequence[Cell], predictions: Sequence[Prediction]) -> str:
    """Return a hash of everything that a lesson runs or reveals: its code, its lesson nodes, and its predictions.

    The lesson's other text doesn't affect the hash.
    """
    code = "\n".join(f"{cell.id}\n{cell.source}" for cell in cells if cell.kind == "code")
    total = hashlib.sha256(f"{FORMAT}\n{code}".encode())
    for path in inputs(tree, text):
        total.update(f"\n{tree.name(path)}\n{path.read_text(encoding='utf-8')}".encode())
    if predictions:
        total.update(f"\n{seal(predictions)}".encode())
    return total.hexdigest()


def _metadata(
    tree: Tree, stem: str, text: str, cells: Sequence[Cell], predictions: Sequence[Prediction]
) -> dict[str, Any]:
    return {
        "lesson": stem,
        "made_from": f"notebooks/sources/{stem}.py",
        "source_sha256": source_sha256(tree, text, cells, predictions),
    }


def _first_line(source: str) -> str:
    line = source.strip().split("\n", 1)[0]
    return line if len(line) <= 50 else line[:49] + "…"
