"""Clean a program's output so that terminals, pages, tables, and files can display it safely."""

import codecs
import re
import unicodedata

_ESCAPES = re.compile(r"\x1b\[[0-?]*[ -/]*[@-~]|\x1b\][^\x07\x1b]*(?:\x07|\x1b\\)")
_BLANK = re.compile(
    "[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180d\u180f\u2800\u3164\ufe00-\ufe0e\uffa0\U000e0100-\U000e01ef]"
)
"""Marks, letters, and symbols that are invisible, but that `_is_seen` would keep."""
_JOINERS = "\u200c\u200d\ufe0f"
_JOINED = re.compile(
    rf"(?<=[^\x00-\x7f])((?:\ufe0f?[\u200c\u200d](?=[^\x00-\x7f])|\ufe0f)(?![{_JOINERS}]))|[{_JOINERS}]+"
)
"""Joiners between letters of a name or parts of an emoji (group 1), and joiners that join nothing (no group)."""
_KEPT = f"\n\t{_JOINERS}"


def plain_text(raw: bytes) -> str:
    """Decode UTF-8 bytes to text without terminal commands or misleading characters (see `without_commands`)."""
    return without_commands(codecs.decode(raw, "utf-8", "replace").replace("\r\n", "\n"))


def without_commands(text: str) -> str:
    """Remove everything that a terminal could interpret as a command, or that could mislead a reader.

    Remove escape sequences, and all control characters except line breaks and tabs. Also remove all invisible
    characters except spaces, because they can make one text look like another, change the writing direction, or hide
    words. Characters that join letters or emoji stay where they join something, because names need them.
    """
    if text.isascii() and text.isprintable():
        return text
    seen = "".join(filter(_is_seen, _BLANK.sub("", _ESCAPES.sub("", text))))
    return _JOINED.sub(r"\1", seen)


def _is_seen(character: str) -> bool:
    """Return whether a character is visible, a line break, a tab, a space, or a joiner."""
    return character.isprintable() or character in _KEPT or unicodedata.category(character) == "Zs"
