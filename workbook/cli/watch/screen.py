"""Show the output of `workbook check --watch`, and read the keys that the user presses."""

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
"""The escape sequences that move the cursor to the top left, clear the screen, and delete the scrollback."""


class WatchScreen:
    """Shows the current output. On a terminal, it replaces the previous output; elsewhere, it's appended."""

    def __init__(self) -> None:
        self.is_terminal = sys.stdout.isatty()
        self.takes_keys = self.is_terminal and sys.stdin.isatty()

    def show(self, text: str, *notes: str) -> None:
        """Show `text` with notes below it.

        On a terminal, shorten `text` if necessary, so that the notes stay visible.
        """
        below = "\n".join(terminal.wrapped(note) for note in notes)
        if self.is_terminal:
            rows = shutil.get_terminal_size().lines - below.count("\n") - 3
            text = _CLEAR + fitted(text, max(3, rows))
        else:
            text = f"── {time.strftime('%H:%M:%S')}\n{text}".rstrip()
        print(f"{text}\n\n{below}", flush=True)

    @contextlib.contextmanager
    def keys(self) -> Iterator[None]:
        """Make the terminal deliver each key right away and without echo. Restore the terminal's settings afterward."""
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
        """Wait up to `wait_s` seconds for a key. Return the key, or "" if none was pressed."""
        if not self.takes_keys:
            time.sleep(wait_s)
            return ""
        if not select.select([sys.stdin], [], [], wait_s)[0]:
            return ""
        pressed = os.read(sys.stdin.fileno(), 100).decode(errors="replace")
        self.takes_keys = bool(pressed)  # reading from a closed terminal returns b"" right away
        return pressed[-1:]


def fitted(text: str, rows: int) -> str:
    """Return `text`, cut to `rows` lines. If it's cut, the last line gives the number of missing lines."""
    lines = text.split("\n")
    if len(lines) <= rows:
        return text
    return "\n".join([*lines[: rows - 1], f"  … and {len(lines) - rows + 1} more lines"])
