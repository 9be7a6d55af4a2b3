"""Define the messages between a slot, which judges answers, and its owner, the process that started it.

A message is a line of JSON. The owner sends a `JudgingOrder` for each answer. To cancel the real-time watch of a judged
program, it sends CANCEL_SOAK. The slot's first line says that it's ready, or why it can't start: `{"broken": "No ROS
domain is free…"}`. If the slot was asked to test its isolation tier, that line also says why the tier doesn't work, if
it doesn't. Then, for each order, the slot sends any number of lines with progress or preliminary judgments. The last
line for an order has `"final": true`.
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
"""The maximum size of a line, in bytes. A judgment contains its recording, which keeps up to 1 MB for each topic."""
CHUNK_BYTES = 1 << 20
CANCEL_SOAK: Message = {"cancel_soak": True}
PLUMBING = "/driver/"
"""The prefix of the topics on which a driver, which calls an answer's functions, exchanges messages with the judge."""


class LineTooLong(ValueError):
    """Raised when a line is longer than any valid message."""


@dataclass(frozen=True)
class JudgingOrder:
    """An order to judge one answer.

    `exercise`: the exercise's stem. `answer`: the answer's code. `soak` and `seed`: see `Judge.judge`. `progress`:
    whether the slot sends its progress.
    """

    exercise: str
    answer: str
    soak: bool
    seed: int | None = None
    progress: bool = False


@dataclass(frozen=True)
class Progress:
    """The progress of one answer's judgment.

    `place`: the number of other answers that are judged first, or 0 once judging has begun. `watched_s`: the time that
    the program has been watched, in seconds of simulated time, or of real time on the wall clock. `messages`: the
    number of messages received on each topic. `latest`: each topic's latest message as plain data, or None if the
    message is large. `types`: each topic's message type.
    """

    place: int = 0
    watched_s: float = 0.0
    messages: Mapping[str, int] = field(default_factory=dict)
    latest: Mapping[str, Any] = field(default_factory=dict)
    types: Mapping[str, str] = field(default_factory=dict)

    def counters(self) -> list[str]:
        """Return the number of messages on each of the program's topics, such as "12 on /chatter"."""
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
    """Return a slot's progress message. Leave out the latest messages if JSON can't represent them."""
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
    """Return the judgment in a message. If the message reports an error, return an `infra_error` with this reason."""
    if "error" in message:
        return Judgement(stem, answer_sha256, "infra_error", message["error"], (), None)
    return judgement_from_json(message["judgement"])


class LineReader:
    """Reads messages from a descriptor. A line with more than `longest` bytes is invalid."""

    def __init__(self, descriptor: int, longest: int = LONGEST_LINE) -> None:
        self._descriptor = descriptor
        self._longest = longest
        self._buffer = bytearray()
        self._searched = 0

    def next(self, timeout_s: float) -> dict[str, Any] | None:
        """Wait up to `timeout_s` seconds for data. Return the next message, or None if it isn't complete yet.

        Raises EOFError at the end of the stream, LineTooLong if a line is too long, and ValueError if a message is
        invalid.
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
