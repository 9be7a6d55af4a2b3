"""Summarize the messages that a notebook's programs publish: rate, last value, and last messages."""

import contextlib
import json
import math
import os
import re
import socket
import struct
from collections import deque
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from workbook.inside.tap import ADDRESS
from workbook.lab.panel.reactions import row_of

WINDOW_S = 10.0
"""A rate is measured over the messages of this many seconds."""
SHORTEST_S = 0.4
"""If all messages arrived within this time, their number is shown instead of a rate."""
KEPT = 20
NUMBERS_KEPT = 60
"""Points in a sparkline."""
LONGEST_VALUE = 90
_MOST_BYTES = 1 << 18
_LONG_DECIMALS = re.compile(r"(\d\.\d{3})\d+(?!\d*e)")
_OF_A_HEADER = ("stamp:", "sec: ", "nanosec: ", "frame_id: ")
_CREDENTIALS = struct.Struct("3i")


class PublishedMessage(NamedTuple):
    """A program's report of a message on a topic, published at `moment` (s).

    `number` counts the topic's messages since the previous report.
    """

    topic: str
    type_name: str
    number: int
    moment: float
    size: int
    data: bytes


class Wire:
    """The socket that receives reports from a domain's programs. Call `open` again until it succeeds."""

    def __init__(self, domain_id: int) -> None:
        self.address = ADDRESS.format(domain_id)
        self.socket: socket.socket | None = None

    def open(self) -> bool:
        """Start listening. Return False while another panel for this domain is listening."""
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
        """Return the reports since the last call (at most 500), except those from other users of this machine."""
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
    """The messages of one topic. `value` is one line; `messages` are the last messages in full.

    `reacts`: the robot shows the topic, so it needs no other drawing.
    """

    value: str = ""
    messages: deque[str] = field(default_factory=lambda: deque(maxlen=KEPT))
    numbers: deque[float] = field(default_factory=lambda: deque(maxlen=NUMBERS_KEPT))
    reacts: bool = False
    _moments: deque[tuple[float, int]] = field(default_factory=deque)
    _count: int = 0

    def add(self, report: PublishedMessage, text: str, message: Any = None) -> None:
        """Add a report, its text, and its message (None if not decoded)."""
        self._count += report.number
        self._moments.append((report.moment, self._count))
        while report.moment - self._moments[0][0] > WINDOW_S and len(self._moments) > 3:
            self._moments.popleft()
        self.value = _in_short(report, text, message)
        self.messages.append(text)
        self.reacts = row_of(report.topic, report.type_name) is not None
        number = getattr(message, "data", None)
        if isinstance(number, (int, float)) and not isinstance(number, bool) and math.isfinite(number):
            self.numbers.append(float(f"{number:.4g}"))

    def news(self, now: float) -> dict[str, object]:
        """Return what the panel shows: rate and value as text, and the last numbers if the topic has numbers."""
        told: dict[str, object] = {"rate": self.rate(now), "value": self.value}
        if len(self.numbers) > 1:
            told |= {"numbers": list(self.numbers), "reacts": self.reacts}
        return told

    def rate(self, now: float) -> str:
        """Describe how often messages arrive."""
        (first, before), (last, count) = self._moments[0], self._moments[-1]
        period = (last - first) / (count - before) if count > before else 0.0
        if last - first < SHORTEST_S:
            return "once" if count == 1 else f"{count} messages"
        if now - last > max(2.5 * period, 1.5):
            return "silent now"
        return f"{1 / period:.0f} Hz" if period < 0.01 else f"{1 / period:.3g} Hz"


def _in_short(report: PublishedMessage, text: str, message: Any) -> str:
    if message is not None and report.type_name == "sensor_msgs/msg/Image":
        return f"{message.width} × {message.height} pixels, {message.encoding}"
    return one_line(text)


def one_line(text: str) -> str:
    """Shorten a message's text to one line: the field `data` if it exists, else all fields.

    At most three decimals are kept. A header is left out, because its stamp changes with every message.
    """
    lines = [line.strip() for line in text.splitlines()]
    if lines and lines[0] == "header:":
        lines = [line for line in lines[1:] if not line.startswith(_OF_A_HEADER)]
    data = [line.removeprefix("data: ") for line in lines if line.startswith("data: ")]
    line = _LONG_DECIMALS.sub(r"\1", ", ".join(data or lines)).replace(":, ", ": ")
    return line if len(line) <= LONGEST_VALUE else f"{line[: LONGEST_VALUE - 1]}…"


def text_of(report: PublishedMessage, message: Any) -> str:
    """Return a message's full text, or its size if it couldn't be decoded."""
    from workbook.ros.topic_monitor import message_text

    return message_text(message) if message is not None else f"({report.size} bytes)"
