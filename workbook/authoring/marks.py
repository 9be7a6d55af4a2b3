"""Find Markdown syntax in places that don't render it, where readers would see the raw characters."""

import re
from collections.abc import Iterator

_EMPHASIS = re.compile(r"(?<![\w*])(\*{1,2})(?![\s*]).+?(?<![\s*])\1(?![\w*])")
_CODE = re.compile(r"`[^`]*`")


def marks_in_html(text: str) -> Iterator[str]:
    """Yield each piece of code in backticks and each emphasized piece in a text that is embedded in HTML."""
    yield from (found[0] for found in _CODE.finditer(text))
    yield from (found[0] for found in _EMPHASIS.finditer(_CODE.sub("", text)))


def marks_in_prediction(text: str) -> Iterator[str]:
    """Yield each piece that is emphasized with `*` in a prediction's option or explanation.

    Code in backticks is allowed. `**` is also allowed, because it's removed before the text is shown.
    """
    yield from (found[0] for found in _EMPHASIS.finditer(_CODE.sub("", text).replace("**", "")))
