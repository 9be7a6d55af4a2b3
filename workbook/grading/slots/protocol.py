"""What a slot and its owner say to each other: lines of JSON.

An owner sends a `JudgingOrder`, and ENOUGH to cut short the real seconds for which a judged program is watched. The
first line from a slot says that it is ready, and what is wrong with its tier if it was told to try it; or why it cannot
begin: `{"broken": "No ROS domain is free…"}`. Then come for each order any number of lines with progress and with a
judgement that is not the last one, and one line with `"final": true`.
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
"""Bytes. A judgement comes with its recording, for which a program may send 1 MB on each topic."""
CHUNK_BYTES = 1 << 20
ENOUGH: Message = {"cancel_soak": True}


class LineTooLong(ValueError):
    """A line has more bytes than any message."""


@dataclass(frozen=True)
class JudgingOrder:
    """One answer to judge. `exercise`: its stem; `answer`: its text; `seed`: see `Judge.judge`.

    `progress`: whether the slot is to send how far it is.
    """

    exercise: str
    answer: str
    soak: bool
    seed: int | None = None
    progress: bool = False


@dataclass(frozen=True)
class Progress:
    """How far the judgement of an answer is.

    `place`: how many others are judged before it; 0 once it is at work. `simulated_s`: simulated time; on the wall
    clock, real time. `messages`: how many came on each topic; `latest`: the last one of each as plain data, None if it
    is large.
    """

    place: int = 0
    simulated_s: float = 0.0
    messages: Mapping[str, int] = field(default_factory=dict)
    latest: Mapping[str, Any] = field(default_factory=dict)


def line_of(message: Message | JudgingOrder) -> bytes:
    """A message as a line."""
    data = asdict(message) if isinstance(message, JudgingOrder) else message
    return json.dumps(data, allow_nan=False).encode() + b"\n"


def progress_message(progress: Progress) -> Message:
    """What a slot sends while it judges. Numbers that JSON does not know are left out."""
    data = asdict(progress)
    try:
        json.dumps(data, allow_nan=False)
    except ValueError:
        data["latest"] = {}
    return {"progress": data}


def judgement_message(judgement: Judgement, *, final: bool) -> Message:
    """What a slot sends when it has judged."""
    return {"final": final, "judgement": judgement_to_json(judgement)}


def error_message(reason: str) -> Message:
    """What a slot sends last on an answer that it could not judge."""
    return {"final": True, "error": reason}


def judgement_in(message: Message, stem: str, answer_sha256: str) -> Judgement:
    """The judgement of a message, or that there is none because of an error in the slot."""
    if "error" in message:
        return Judgement(stem, answer_sha256, "infra_error", message["error"], (), None)
    return judgement_from_json(message["judgement"])


class LineReader:
    """Reads messages from a descriptor. A line of more than `longest` bytes is none."""

    def __init__(self, descriptor: int, longest: int = LONGEST_LINE) -> None:
        self._descriptor = descriptor
        self._longest = longest
        self._buffer = bytearray()
        self._searched = 0

    def next(self, timeout_s: float) -> dict[str, Any] | None:
        """The next message; None if it is not there after `timeout_s`, or only a part of it.

        Raises EOFError at the end, LineTooLong, and ValueError for what is no message.
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
