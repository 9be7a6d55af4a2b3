"""Clean a program's output so that it can be displayed safely in terminals, pages, tables, and files."""

import codecs
import re
import unicodedata

_ESCAPES = re.compile(r"\x1b\[[0-?]*[ -/]*[@-~]|\x1b\][^\x07\x1b]*(?:\x07|\x1b\\)")
_BLANK = re.compile(
    "[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180d\u180f\u2800\u3164\ufe00-\ufe0e\uffa0\U000e0100-\U000e01ef]"
)
"""Matches invisible marks, letters, and symbols that `_is_seen` would keep."""
_JOINERS = "\u200c\u200d\ufe0f"
_JOINED = re.compile(
    rf"(?<=[^\x00-\x7f])((?:\ufe0f?[\u200c\u200d](?=[^\x00-\x7f])|\ufe0f)(?![{_JOINERS}]))|[{_JOINERS}]+"
)
"""Matches all joiners. Those between the letters of a name or the parts of an emoji are group 1."""
_KEPT = f"\n\t{_JOINERS}"


def plain_text(raw: bytes) -> str:
    """Decode UTF-8 bytes, and remove terminal commands and misleading characters (see `without_commands`)."""
    return without_commands(codecs.decode(raw, "utf-8", "replace").replace("\r\n", "\n"))


def without_commands(text: str) -> str:
    """Remove everything that a terminal could interpret as a command or that could mislead a reader.

    Remove escape sequences, and all control characters except line breaks and tabs. Also remove all invisible
    characters except spaces, because they can make one string look like another, change the writing direction, or hide
    words. Characters that join letters or emoji stay where they join something, because some names contain them.
    """
    if text.isascii() and text.isprintable():
        return text
    seen = "".join(filter(_is_seen, _BLANK.sub("", _ESCAPES.sub("", text))))
    return _JOINED.sub(r"\1", seen)


def _is_seen(character: str) -> bool:
    """Return whether a character is visible, a line break, a tab, a space, or a joiner."""
    return character.isprintable() or character in _KEPT or unicodedata.category(character) == "Zs"
