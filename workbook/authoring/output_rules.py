"""Rules for a lesson's outputs, and for the number of outputs that nbval may ignore."""

import re
from collections.abc import Iterator

from workbook.authoring import document
from workbook.authoring.outputs import texts
from workbook.lesson.measured import UNUSUAL

IGNORE_OUTPUT = "nbval-ignore-output"
LARGEST_IGNORED_SHARE = 1 / 3
_MARKERS = re.compile(
    r"^\s*#.*\b(NBVAL_IGNORE_OUTPUT|NBVAL_CHECK_OUTPUT|NBVAL_SKIP|NBVAL_RAISES_EXCEPTION|"
    r"PYTEST_VALIDATE_IGNORE_OUTPUT)\b",
    re.MULTILINE,
)
Finding = tuple[int, str]
"""A line number in the lesson's text (0 for the whole lesson), and a message for the author."""


def compared_enough(wanted: document.Document) -> Iterator[Finding]:
    """Check that nbval ignores the outputs of at most a third of the code cells.

    Also check that cells give nbval its instructions in tags, not in comments.
    """
    code = [cell for cell in wanted.cells if cell.kind == "code"]
    for cell in code:
        found = _MARKERS.search(cell.source)
        if found:
            yield cell.line, f"cell {cell.id}: write a tag instead of the comment {found[1]}"
    ignored = [cell for cell in code if IGNORE_OUTPUT in cell.tags]
    if len(ignored) > len(code) * LARGEST_IGNORED_SHARE:
        yield 0, f"{len(ignored)} of {len(code)} code cells ignore their output; at most a third may"


def outputs_in_order(built: document.Notebook) -> Iterator[str]:
    """Check a built lesson's outputs: the execution order, errors, figures, and numbers outside their range."""
    code = [cell for cell in built.cells if cell.cell_type == "code"]
    if [cell.execution_count for cell in code] != list(range(1, len(code) + 1)):
        yield "was not run from top to bottom: run `make notebooks`"
        return
    for cell in code:
        tags = cell.metadata.get("tags", [])
        kinds = [kind for output in cell.outputs for kind in _kinds(output)]
        if "error" in kinds and "raises-exception" not in tags:
            yield f"cell {cell.id} shows an error without the tag raises-exception"
        if "error" not in kinds and "raises-exception" in tags:
            yield f"cell {cell.id} is tagged raises-exception, but raised none"
        yield from _pictures(cell)
        if any(UNUSUAL in text for output in cell.outputs for text in texts(output)):
            yield f"cell {cell.id} shows a number that is {UNUSUAL}: run it again, or widen its range"
    if not any(_is_picture(output) for cell in code for output in cell.outputs):
        yield "shows no figure: a lesson has at least one that moves or explains"


def _is_picture(output: document.Notebook) -> bool:
    page = "".join(output.get("data", {}).get("text/html", ""))
    return any(kind.startswith("image/") for kind in _kinds(output)) or "<img" in page or "<svg" in page


def _kinds(output: document.Notebook) -> list[str]:
    if output.output_type in ("stream", "error"):
        return [output.output_type]
    return list(output.data)


def _pictures(cell: document.Notebook) -> Iterator[str]:
    for output in cell.outputs:
        if not any(kind.startswith("image/") for kind in _kinds(output)):
            continue
        described = [text for text in texts(output) if not text.lstrip().startswith("<")]
        if not described:
            yield f"cell {cell.id}: its figure has no text/plain that says what it shows"
