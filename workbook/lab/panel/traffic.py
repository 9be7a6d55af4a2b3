"""What the programs of a notebook say that they publish: how often, the last value, the last messages."""

import contextlib
import json
import os
import re
import socket
import struct
from collections import deque
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from workbook.inside.tap import ADDRESS

WINDOW_S = 10.0
"""A rate is measured over the messages of so many seconds."""
SHORTEST_S = 0.4
"""Messages within so short a time are told by their number."""
KEPT = 20
LONGEST_VALUE = 90
_MOST_BYTES = 1 << 18
_LONG_DECIMALS = re.compile(r"(\d\.\d{3})\d+(?!\d*e)")
_CREDENTIALS = struct.Struct("3i")


class PublishedMessage(NamedTuple):
    """A message that a program has published: the `number` of that topic since the report before, at `moment` (s)."""

    topic: str
    type_name: str
    number: int
    moment: float
    size: int
    data: bytes


class Wire:
    """The socket on which the programs of a domain report. `open` may have to be tried again."""

    def __init__(self, domain_id: int) -> None:
        self.address = ADDRESS.format(domain_id)
        self.socket: socket.socket | None = None

    def open(self) -> bool:
        """Listen; False while another panel of this domain does."""
        if self.socket is None:
            wire = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM | socket.SOCK_NONBLOCK)
            wire.setsockopt(socket.SOL_SOCKET, socket.SO_PASSCRED, 1)
            wire.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
            try:
                wire.bind(self.address)
            except OSError:
                wire.close()
            else:
                self.socket = wire
        return self.socket is not None

    def close(self) -> None:
        """Stop listening."""
        if self.socket is not None:
            self.socket.close()
            self.socket = None

    def reports(self) -> list[PublishedMessage]:
        """What has come since; nothing from other users of this machine."""
        found: list[PublishedMessage] = []
        while self.socket is not None and len(found) < 500:
            try:
                packet, ancillary, _, _ = self.socket.recvmsg(
                    _MOST_BYTES, socket.CMSG_SPACE(_CREDENTIALS.size)
                )
            except BlockingIOError:
                break
            if _sender(ancillary) == os.getuid():
                with contextlib.suppress(ValueError, TypeError):
                    head, _, data = packet.partition(b"\n")
                    topic, type_name, count, moment, size = json.loads(head)
                    found.append(
                        PublishedMessage(
                            str(topic), str(type_name), int(count), float(moment), int(size), data
                        )
                    )
        return found


def _sender(ancillary: list[tuple[int, int, bytes]]) -> int | None:
    for level, kind, data in ancillary:
        if (level, kind) == (socket.SOL_SOCKET, socket.SCM_CREDENTIALS):
            return int(_CREDENTIALS.unpack(data[: _CREDENTIALS.size])[1])
    return None


@dataclass
class Traffic:
    """What was heard of one topic. `value` is one line, `messages` are the last ones in full."""

    value: str = ""
    messages: deque[str] = field(default_factory=lambda: deque(maxlen=KEPT))
    _moments: deque[tuple[float, int]] = field(default_factory=deque)
    _count: int = 0

    def add(self, report: PublishedMessage, text: str) -> None:
        """Take in a message and its text."""
        self._count += report.number
        self._moments.append((report.moment, self._count))
        while report.moment - self._moments[0][0] > WINDOW_S and len(self._moments) > 3:
            self._moments.popleft()
        self.value = one_line(text)
        self.messages.append(text)

    def rate(self, now: float) -> str:
        """How often messages come, in words."""
        (first, before), (last, count) = self._moments[0], self._moments[-1]
        period = (last - first) / (count - before) if count > before else 0.0
        if last - first < SHORTEST_S:
            return "once" if count == 1 else f"{count} messages"
        if now - last > max(2.5 * period, 1.5):
            return "silent now"
        return f"{1 / period:.0f} Hz" if period < 0.01 else f"{1 / period:.3g} Hz"


def one_line(text: str) -> str:
    """A message in short: what `data` holds where there is such a field, else the fields; decimals cut to three."""
    lines = [line.strip() for line in text.splitlines()]
    data = [line.removeprefix("data: ") for line in lines if line.startswith("data: ")]
    line = _LONG_DECIMALS.sub(r"\1", ", ".join(data or lines))
    return line if len(line) <= LONGEST_VALUE else f"{line[: LONGEST_VALUE - 1]}…"


def text_of(report: PublishedMessage, message: Any) -> str:
    """A message in full, or what can be said of it."""
    from workbook.ros.topic_monitor import message_text

    return message_text(message) if message is not None else f"({report.size} bytes)"
