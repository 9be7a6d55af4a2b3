"""Define the messages between a slot and its owner: lines of JSON.

The owner sends a `JudgingOrder` for each answer. To end the real-time watch of a judged program early, it sends ENOUGH.
The slot's first line says that it's ready, or why it can't start: `{"broken": "No ROS domain is free…"}`. If the slot
was asked to test its tier, that line also reports the tier's problem. Then, for each order, the slot sends any number
of lines with progress or preliminary judgments. The order's last line has `"final": true`.
"""

import json
import os
import select
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any

from workbook.exercise.judgement import Judgement
from workbook.exercise.serialization import judgement_from_json, judgement_to_json

Message = Mapping[str, Any]

LONGEST_LINE = 200_000_000
"""The most bytes in a line. A judgment includes its recording, for which a program may send 1 MB on each topic."""
CHUNK_BYTES = 1 << 20
ENOUGH: Message = {"cancel_soak": True}
PLUMBING = "/driver/"
"""The prefix of the topics through which a driver calls an answer's functions. Only the judge uses their messages."""


class LineTooLong(ValueError):
    """A line is longer than any valid message."""


@dataclass(frozen=True)
class JudgingOrder:
    """An order to judge one answer. `exercise`: its stem. `answer`: its text. `seed`: see `Judge.judge`.

    `progress`: whether the slot sends its progress.
    """

    exercise: str
    answer: str
    soak: bool
    seed: int | None = None
    progress: bool = False


@dataclass(frozen=True)
class Progress:
    """The progress of one answer's judgment.

    `place`: how many other answers are judged first; 0 once judging has begun. `watched_s`: how long the program has
    been watched, in seconds of simulated time, or of real time on the wall clock. `messages`: the number received on
    each topic. `latest`: each topic's last message as plain data; None if it's large. `types`: each topic's message
    type.
    """

    place: int = 0
    watched_s: float = 0.0
    messages: Mapping[str, int] = field(default_factory=dict)
    latest: Mapping[str, Any] = field(default_factory=dict)
    types: Mapping[str, str] = field(default_factory=dict)

    def counters(self) -> list[str]:
        """Return the message count of each of the program's topics, in words."""
        counted = ((topic, count) for topic, count in self.messages.items() if not topic.startswith(PLUMBING))
        return [f"{count} on {topic}" for topic, count in counted]

    def __str__(self) -> str:
        """Describe the progress in a few words."""
        if self.place:
            return f"{self.place} answers before yours" if self.place > 1 else "1 answer before yours"
        return ", ".join((f"{self.watched_s:.1f} s", *self.counters()))


def line_of(message: Message | JudgingOrder) -> bytes:
    """Encode a message as a line."""
    data = asdict(message) if isinstance(message, JudgingOrder) else message
    return json.dumps(data, allow_nan=False).encode() + b"\n"


def progress_message(progress: Progress) -> Message:
    """Return a slot's progress message. If JSON can't represent the latest messages, they're left out."""
    data = asdict(progress)
    try:
        json.dumps(data, allow_nan=False)
    except ValueError:
        data["latest"] = {}
    return {"progress": data}


def judgement_message(judgement: Judgement, *, final: bool) -> Message:
    """Return a slot's message with a judgment."""
    return {"final": final, "judgement": judgement_to_json(judgement)}


def error_message(reason: str) -> Message:
    """Return a slot's last message about an answer that it couldn't judge."""
    return {"final": True, "error": reason}


def judgement_in(message: Message, stem: str, answer_sha256: str) -> Judgement:
    """Return a message's judgment. If the slot reported an error, return a judgment that says so."""
    if "error" in message:
        return Judgement(stem, answer_sha256, "infra_error", message["error"], (), None)
    return judgement_from_json(message["judgement"])


class LineReader:
    """Reads messages from a descriptor. A line of more than `longest` bytes is invalid."""

    def __init__(self, descriptor: int, longest: int = LONGEST_LINE) -> None:
        self._descriptor = descriptor
        self._longest = longest
        self._buffer = bytearray()
        self._searched = 0

    def next(self, timeout_s: float) -> dict[str, Any] | None:
        """Return the next message; None if it isn't complete after `timeout_s` seconds.

        Raises EOFError at the end of the stream, LineTooLong, and ValueError for an invalid message.
        """
        if (message := self._take()) is not None:
            return message
        if not select.select([self._descriptor], [], [], timeout_s)[0]:
            return None
        chunk = os.read(self._descriptor, CHUNK_BYTES)
        if not chunk:
            raise EOFError
        self._buffer += chunk
        return self._take()

    def _take(self) -> dict[str, Any] | None:
        end = self._buffer.find(b"\n", self._searched)
        if max(end, len(self._buffer) if end < 0 else 0) > self._longest:
            raise LineTooLong(f"a line is longer than {self._longest} bytes")
        if end < 0:
            self._searched = len(self._buffer)
            return None
        message = json.loads(self._buffer[:end])
        del self._buffer[: end + 1]
        self._searched = 0
        if not isinstance(message, dict):
            raise ValueError("a line that is no message")
        return message
