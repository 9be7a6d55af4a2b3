"""Text of a program, fit for terminals, pages, tables and files."""

import codecs
import re
import unicodedata

_ESCAPES = re.compile(r"\x1b\[[0-?]*[ -/]*[@-~]|\x1b\][^\x07\x1b]*(?:\x07|\x1b\\)")
_BLANK = re.compile(
    "[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180d\u180f\u2800\u3164\ufe00-\ufe0e\uffa0\U000e0100-\U000e01ef]"
)
"""Marks, letters and symbols that show nothing."""
_JOINERS = "\u200c\u200d\ufe0f"
_JOINED = re.compile(
    rf"(?<=[^\x00-\x7f])((?:\ufe0f?[\u200c\u200d](?=[^\x00-\x7f])|\ufe0f)(?![{_JOINERS}]))|[{_JOINERS}]+"
)
"""What joins letters of a name or parts of an emoji (group 1), and the same signs where they join nothing."""
_KEPT = f"\n\t{_JOINERS}"


def plain_text(raw: bytes) -> str:
    """Text that no terminal, page or file can take for a command: see `without_commands`."""
    return without_commands(codecs.decode(raw, "utf-8", "replace").replace("\r\n", "\n"))


def without_commands(text: str) -> str:
    """The same text, with everything taken out that a terminal or a reader's eye could take for a command.

    Escapes and control characters go, but for line breaks and tabs. So does all that is invisible and no space: it can
    make a text look like another one, turn the direction of writing, or hide words. The signs that join letters and
    emoji stay between those: names need them.
    """
    if text.isascii() and text.isprintable():
        return text
    seen = "".join(filter(_is_seen, _BLANK.sub("", _ESCAPES.sub("", text))))
    return _JOINED.sub(r"\1", seen)


def _is_seen(character: str) -> bool:
    """Whether a character shows something, breaks a line, is a space, or may join others."""
    return character.isprintable() or character in _KEPT or unicodedata.category(character) == "Zs"
