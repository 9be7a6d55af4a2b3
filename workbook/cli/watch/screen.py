"""The one screen of `workbook check --watch`: what it shows, and the keys that it takes."""

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
"""Cursor to the first place, clear the screen, forget what was scrolled away."""


class WatchScreen:
    """Shows one text at a time: on a terminal each replaces the one before it, elsewhere they follow one another."""

    def __init__(self) -> None:
        self.is_terminal = sys.stdout.isatty()
        self.takes_keys = self.is_terminal and sys.stdin.isatty()

    def show(self, text: str, *notes: str) -> None:
        """Show a text and, below it, notes, which stay in sight however long the text is."""
        below = "\n".join(terminal.wrapped(note) for note in notes)
        if self.is_terminal:
            rows = shutil.get_terminal_size().lines - below.count("\n") - 3
            text = _CLEAR + fitted(text, max(3, rows))
        else:
            text = f"── {time.strftime('%H:%M:%S')}\n{text}".rstrip()
        print(f"{text}\n\n{below}", flush=True)

    @contextlib.contextmanager
    def keys(self) -> Iterator[None]:
        """Let each key come through at once, without being shown; afterwards the terminal is as it was."""
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
        """The key that was pressed within `wait_s` s; empty when there was none."""
        if not self.takes_keys:
            time.sleep(wait_s)
            return ""
        if not select.select([sys.stdin], [], [], wait_s)[0]:
            return ""
        pressed = os.read(sys.stdin.fileno(), 100).decode(errors="replace")
        self.takes_keys = bool(pressed)  # a terminal that was closed is always ready, and has nothing
        return pressed[-1:]


def fitted(text: str, rows: int) -> str:
    """As much of a text as fits into `rows` lines."""
    lines = text.split("\n")
    if len(lines) <= rows:
        return text
    return "\n".join([*lines[: rows - 1], f"  … and {len(lines) - rows + 1} more lines"])
