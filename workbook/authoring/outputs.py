"""Normalize a run's outputs, so that they are as similar as possible on every machine."""

import re
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any

import nbformat

from workbook.lesson.measured import MARK

SANITIZE = Path(__file__).with_name("sanitize.cfg")
"""The file with patterns and their replacements, in nbval's format. Both the builder and nbval use it."""


@cache
def patterns() -> tuple[tuple[re.Pattern[str], str], ...]:
    """Return the sanitize file's (pattern, replacement) pairs."""
    text = SANITIZE.read_text(encoding="utf-8")
    pairs = re.findall(r"^regex: (.*)$\n^replace: (.*)$", text, flags=re.MULTILINE)
    return tuple((re.compile(regex), replacement) for regex, replacement in pairs)


PICTURE = re.compile(r'(src(?:set)?="data:image/[a-z+]+;base64,[^"]*")')
"""An image inside HTML."""
_MARKED = re.compile(rf"{MARK} -?\d[\d,]*(?:\.\d+)?")
_SPACES = re.compile(r" {2,}")


def sanitized(text: str) -> str:
    """Replace memory addresses, timestamps, and machine paths in a string. Leave images inside HTML unchanged."""
    pieces = PICTURE.split(text)
    for place in range(0, len(pieces), 2):
        for pattern, replacement in patterns():
            pieces[place] = pattern.sub(replacement, pieces[place])
    return "".join(pieces)


def without_pictures(text: str) -> str:
    """Replace the data of each image inside HTML with a fixed word."""
    return PICTURE.sub('src="picture"', text)


def without_numbers(text: str) -> str:
    """Replace each number marked as varying with the word "number".

    In lines with such numbers, also remove the spaces that align columns.
    """
    lines = text.split("\n")
    for place, line in enumerate(lines):
        if _MARKED.search(line):
            lines[place] = _SPACES.sub(" ", _MARKED.sub(f"{MARK} number", line))
    return "\n".join(lines)


def normalize(notebook: nbformat.NotebookNode) -> None:
    """Number the code cells from 1, and clean and merge their outputs, in place."""
    for count, cell in enumerate((cell for cell in notebook.cells if cell.cell_type == "code"), start=1):
        cell.execution_count = count
        cell.outputs = _merged(cell.outputs)
        cell.metadata.pop("execution", None)
        for output in cell.outputs:
            _clean(output)
            if output.output_type == "execute_result":
                output.execution_count = count


def texts(output: Any) -> Iterable[str]:
    """Yield every piece of text in an output."""
    if output.output_type == "stream":
        yield output.text
    elif output.output_type == "error":
        yield output.evalue
        yield from output.traceback
    else:
        yield from (value for kind, value in output.data.items() if _is_text(kind, value))


def _merged(outputs: list[Any]) -> list[Any]:
    merged: list[Any] = []
    for output in outputs:
        last = merged[-1] if merged else None
        is_stream = output.output_type == "stream"
        if is_stream and last is not None and last.output_type == "stream" and last.name == output.name:
            last.text += output.text
        else:
            merged.append(output)
    return merged


def _clean(output: Any) -> None:
    if output.output_type == "stream":
        output.text = sanitized(output.text)
    elif output.output_type == "error":
        output.evalue = sanitized(output.evalue)
        output.traceback = [sanitized(line) for line in output.traceback]
    else:
        output.pop("transient", None)
        for kind, value in output.data.items():
            if _is_text(kind, value):
                output.data[kind] = sanitized(value)


def _is_text(kind: str, value: object) -> bool:
    return isinstance(value, str) and (kind.startswith("text/") or kind == "image/svg+xml")
