"""HTML from templates, `PACKAGE/templates/NAME.html.j2`, with Jinja2, which escapes all text that comes into them.

Imports nothing of `workbook` but how text is made plain, so that every layer may use it. Jinja2 itself is imported when
the first template is rendered: a grader or a check in a terminal shows no HTML, and does not wait for it.
"""

from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from workbook.recording.plain_text import without_commands

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup

_PACKAGE = Path(__file__).parent


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
    return environment


def _plain(value: object) -> object:
    """What comes into a template, without what a reader cannot see. Markup was rendered already."""
    return without_commands(value) if type(value) is str else value


def render(template: str, **values: Any) -> str:
    """The HTML of a template, such as "feedback/card"."""
    package, name = template.split("/")
    return _environment().get_template(f"{package}/templates/{name}.html.j2").render(**values)


def as_markup(text: str) -> "Markup":
    """HTML that was rendered already, for another template: it is not escaped again."""
    from markupsafe import Markup

    return Markup(text)
