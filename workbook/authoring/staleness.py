"""Check whether a built notebook matches its text, and whether its links lead to existing files."""

import re
from collections.abc import Iterator
from pathlib import Path

from workbook.authoring import document
from workbook.authoring.tree import Tree
from workbook.authoring.violations import Violation

_CODE = re.compile(r"(`+).+?\1", re.DOTALL)
_LINK = re.compile(r"(?P<image>!?)\[(?P<text>[^\]]*)\]\(\s*(?P<target>[^)\s]+)[^)]*\)")


def stale(tree: Tree, target: Path, wanted: document.Document) -> Iterator[Violation]:
    """Yield a violation if a notebook is missing or unreadable, and one for each difference from its text."""
    name = tree.name(target)
    if not target.is_file():
        yield Violation(name, "is not built: run `make notebooks`")
        return
    try:
        built = document.read(target)
    except ValueError as error:
        yield Violation(name, str(error))
        return
    for words in differences(document.without_outputs(built), document.as_notebook(wanted)):
        yield Violation(name, f"{words}: run `make notebooks`")


def differences(built: document.Notebook, wanted: document.Notebook) -> Iterator[str]:
    """Yield each difference between a built notebook without outputs and the notebook that its text generates."""
    ids, wanted_ids = [cell.get("id") for cell in built.cells], [cell.id for cell in wanted.cells]
    if ids != wanted_ids:
        extra = [str(one) for one in ids if one not in wanted_ids]
        lacking = [one for one in wanted_ids if one not in ids]
        told = [f"has {', '.join(extra)}" * bool(extra), f"lacks {', '.join(lacking)}" * bool(lacking)]
        yield f"cell ids differ from the text ({'; '.join(filter(None, told)) or 'other order'})"
    by_id = {cell.id: cell for cell in wanted.cells}
    for cell in built.cells:
        other = by_id.get(cell.get("id"))
        if other is None:
            continue
        if (cell.cell_type, cell.source) != (other.cell_type, other.source):
            yield f"cell {cell.id} differs from the text"
        elif cell.metadata.get("tags", []) != other.metadata.get("tags", []):
            yield f"cell {cell.id} has other tags than the text"
        elif dict(cell.metadata) != dict(other.metadata):
            yield f"cell {cell.id} has metadata that the text does not give"
    if dict(built.metadata) != dict(wanted.metadata):
        mine, theirs = (dict(n.metadata.get("workbook", {})) for n in (built, wanted))
        hashes = mine.pop("source_sha256", None), theirs.pop("source_sha256", None)
        rest_same = mine == theirs and {**built.metadata, "workbook": 0} == {**wanted.metadata, "workbook": 0}
        if rest_same and hashes[0] != hashes[1]:
            yield "its outputs are older than its text or a lesson node that it runs"
        else:
            yield "its metadata is not what the text gives"
    if built.nbformat_minor != wanted.nbformat_minor:
        yield f"has notebook format 4.{built.nbformat_minor} and not 4.{wanted.nbformat_minor}"


def dead_links(tree: Tree, folder: Path, wanted: document.Document) -> Iterator[tuple[int, str]]:
    """Yield a line number and a message for each link to a missing file and each image without alternative text."""
    for cell in wanted.cells:
        if cell.kind != "markdown":
            continue
        for link in _LINK.finditer(_CODE.sub("", cell.source)):
            target = link["target"].split("#", 1)[0]
            if link["image"] and not link["text"].strip():
                yield cell.line, f"cell {cell.id}: the figure {target} has no alternative text"
            if not target or re.match(r"[a-z]+:", target):
                continue
            path = (folder / target).resolve()
            named = tree.sources if path.parent == tree.notebooks.resolve() else tree.solutions
            known = path.suffix == ".ipynb" and (named / f"{path.stem}.py").is_file()
            if not known and not path.exists():
                yield cell.line, f"cell {cell.id}: the link to {target} leads nowhere"
