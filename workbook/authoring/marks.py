"""Marks of Markdown where nothing renders them: the reader would see them as they are written."""

import re
from collections.abc import Iterator

_EMPHASIS = re.compile(r"(?<![\w*])(\*{1,2})(?![\s*]).+?(?<![\s*])\1(?![\w*])")
_CODE = re.compile(r"`[^`]*`")


def marks_in_html(text: str) -> Iterator[str]:
    """Code in backticks and emphasis in a text that stands in HTML."""
    yield from (found[0] for found in _CODE.finditer(text))
    yield from (found[0] for found in _EMPHASIS.finditer(_CODE.sub("", text)))


def marks_in_prediction(text: str) -> Iterator[str]:
    """Emphasis in an option of a prediction or its explanation. These may have code; bold words lose their marks."""
    yield from (found[0] for found in _EMPHASIS.finditer(_CODE.sub("", text).replace("**", "")))
