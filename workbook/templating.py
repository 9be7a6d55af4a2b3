"""Render HTML from the Jinja2 templates `PACKAGE/templates/NAME.html.j2`. All inserted text is escaped.

From `workbook`, this module imports only `without_commands`, so that every layer may use it. Jinja2 itself is imported
when the first template is rendered, because grading or a check in a terminal doesn't show HTML.
"""

import re
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from workbook.recording.plain_text import without_commands

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup

_PACKAGE = Path(__file__).parent
_LONG_NAME = re.compile(r"\S{20,}")  # a shorter name fits on a line of a card's table, so it stays whole
_PLACE_TO_WRAP = re.compile(r"(?<=\w)([/_])(?=\w)")


@cache
def _environment() -> "Environment":
    from jinja2 import Environment, FileSystemLoader, StrictUndefined

    environment = Environment(
        loader=FileSystemLoader(_PACKAGE),
        autoescape=True,
        finalize=_plain,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["number"] = "{:g}".format
    environment.filters["breakable"] = breakable
    return environment


def _plain(value: object) -> object:
    """Remove invisible characters from a template's value. Markup is already clean."""
    return without_commands(value) if type(value) is str else value


def breakable(text: str) -> "Markup":
    """Escape the text, and let long names in it wrap after each `/` and `_` between two letters or digits."""
    from markupsafe import Markup, escape

    # Text without commands contains no null character, so one can mark a place until the text is escaped.
    marked = _LONG_NAME.sub(lambda name: _PLACE_TO_WRAP.sub("\\1\0", name[0]), without_commands(text))
    return Markup(str(escape(marked)).replace("\0", "<wbr>"))


def render(template: str, **values: Any) -> str:
    """Render a template as HTML: "feedback/card" stands for `feedback/templates/card.html.j2`."""
    package, name = template.split("/")
    return _environment().get_template(f"{package}/templates/{name}.html.j2").render(**values)


def as_markup(text: str) -> "Markup":
    """Mark rendered HTML as markup, so that another template doesn't escape it again."""
    from markupsafe import Markup

    return Markup(text)
