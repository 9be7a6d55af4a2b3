"""Define the screen of `workbook check --watch`, and the keys that it accepts."""

import contextlib
import os
import select
import shutil
import sys
import termios
import time
from collections.abc import Iterator

from workbook.cli import terminal

_CLEAR = "\x1b[H\x1b[2J\x1b[3J"
"""Moves the cursor to the top left, clears the screen, and deletes the scrollback."""


class WatchScreen:
    """Shows one text at a time. On a terminal, each text replaces the previous one; elsewhere, texts are appended."""

    def __init__(self) -> None:
        self.is_terminal = sys.stdout.isatty()
        self.takes_keys = self.is_terminal and sys.stdin.isatty()

    def show(self, text: str, *notes: str) -> None:
        """Show a text with notes below it. On a terminal, shorten the text so that the notes stay visible."""
        below = "\n".join(terminal.wrapped(note) for note in notes)
        if self.is_terminal:
            rows = shutil.get_terminal_size().lines - below.count("\n") - 3
            text = _CLEAR + fitted(text, max(3, rows))
        else:
            text = f"── {time.strftime('%H:%M:%S')}\n{text}".rstrip()
        print(f"{text}\n\n{below}", flush=True)

    @contextlib.contextmanager
    def keys(self) -> Iterator[None]:
        """Make the terminal deliver each key right away, without echo. Restore its settings afterward."""
        if not self.takes_keys:
            yield
            return
        before = termios.tcgetattr(sys.stdin)
        changed = termios.tcgetattr(sys.stdin)
        changed[3] &= ~(termios.ICANON | termios.ECHO)
        termios.tcsetattr(sys.stdin, termios.TCSANOW, changed)
        try:
            yield
        finally:
            termios.tcsetattr(sys.stdin, termios.TCSANOW, before)

    def key(self, wait_s: float) -> str:
        """Wait up to `wait_s` seconds for a key, and return it; "" if none was pressed."""
        if not self.takes_keys:
            time.sleep(wait_s)
            return ""
        if not select.select([sys.stdin], [], [], wait_s)[0]:
            return ""
        pressed = os.read(sys.stdin.fileno(), 100).decode(errors="replace")
        self.takes_keys = bool(pressed)  # a closed terminal is always readable, but returns nothing
        return pressed[-1:]


def fitted(text: str, rows: int) -> str:
    """Return the text, cut to `rows` lines. If it's cut, the last line says how many lines are missing."""
    lines = text.split("\n")
    if len(lines) <= rows:
        return text
    return "\n".join([*lines[: rows - 1], f"  … and {len(lines) - rows + 1} more lines"])
