"""Keep a program's output, up to a limit."""

import os
import re
import threading
import time
from collections.abc import Callable

from workbook.recording.plain_text import plain_text

LOG_KEPT_BYTES = 8_000
_OWN_FRAME = re.compile(
    r'^ *File "(?:[^"\n]*/workbook/inside/\w+\.py|<frozen (?:runpy|importlib\.\w+)>)", line \d+[^\n]*\n'
    r"(?: {4}[^\n]*\n)*",
    re.MULTILINE,
)
"""Matches a stack frame of our code in a traceback that a program prints.

Programs print tracebacks with print_stack(), faulthandler, or logging.
"""


class ProgramLog:
    """Reads a program's output, and keeps its beginning and its end.

    Calls `on_flood` once, when the output exceeds `limit` bytes.
    """

    def __init__(self, stream_fd: int, limit: int, on_flood: Callable[[], None]) -> None:
        self._fd = stream_fd
        self._limit = limit
        self._on_flood = on_flood
        self._head = bytearray()
        self._tail = bytearray()
        self._seen = 0
        self.flooded = False
        self.printed_at: float | None = None  # time.monotonic() of the latest output
        self._thread = threading.Thread(target=self._read, name="program log", daemon=True)
        self._thread.start()

    def _read(self) -> None:
        half = LOG_KEPT_BYTES // 2
        try:
            while chunk := os.read(self._fd, 65536):
                self._seen += len(chunk)
                self.printed_at = time.monotonic()
                room = half - len(self._head)
                if room > 0:
                    self._head += chunk[:room]
                    chunk = chunk[room:]
                self._tail += chunk
                del self._tail[:-half]
                if self._seen > self._limit and not self.flooded:
                    self.flooded = True
                    self._on_flood()
        except OSError:
            pass
        finally:
            os.close(self._fd)

    def finish(self, timeout_s: float) -> None:
        """Wait until all output has been read, but no longer than `timeout_s` seconds."""
        self._thread.join(timeout_s)

    @property
    def truncated(self) -> bool:
        """Whether the middle of the output was left out."""
        return self._seen > LOG_KEPT_BYTES

    def text(self) -> str:
        """Return the kept parts of the log, without stack frames of our code."""
        head, tail = bytes(self._head), bytes(self._tail)
        if self._seen <= len(head) + len(tail):
            return _without_own_frames(plain_text(head + tail))
        left_out = self._seen - len(head) - len(tail)
        return _without_own_frames(f"{plain_text(head)}\n… {left_out} bytes left out …\n{plain_text(tail)}")


def _without_own_frames(text: str) -> str:
    return _OWN_FRAME.sub("", text) if "/inside/" in text or "<frozen" in text else text
