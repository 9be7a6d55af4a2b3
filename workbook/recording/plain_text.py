"""Text of a program, fit for terminals, pages and files."""

import codecs
import re

_CONTROL = re.compile(
    r"\x1b\[[0-?]*[ -/]*[@-~]|\x1b\][^\x07\x1b]*(?:\x07|\x1b\\)|[\x00-\x08\x0b-\x1f\x7f-\x9f]"
    r"|[\u200e\u200f\u202a-\u202e\u2066-\u2069]"
)


def plain_text(raw: bytes) -> str:
    """Text that no terminal, page or file can take for a command: no escapes, no control characters.

    Marks that turn the direction of writing go, too: they can make a line read as something that it is not.
    """
    return without_commands(codecs.decode(raw, "utf-8", "replace").replace("\r\n", "\n"))


def without_commands(text: str) -> str:
    """The same text, with everything taken out that a terminal or a reader's eye could take for a command."""
    return _CONTROL.sub("", text)
