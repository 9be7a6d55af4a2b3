"""Judge arrays that arrive on a topic."""

import math
import statistics
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise
from typing import Any

from workbook.criteria.criterion import Topic
from workbook.criteria.rules import Words, otherwise
from workbook.criteria.verdict import Verdict, passed
from workbook.criteria.vocabulary.estimators import PAIR_FRACTION
from workbook.criteria.vocabulary.phrasing import count, listing
from workbook.criteria.vocabulary.silences import program_ended
from workbook.criteria.vocabulary.topics import if_all_kept, if_messages
from workbook.criteria.vocabulary.values import elements, length_of, values
from workbook.recording.recording import Recording

WORDS = Words(__file__)

LEAST_MESSAGES = 3
MOSTLY = 0.75
"""The least fraction of the steps from one message to the next in which enough elements must change."""


@dataclass(frozen=True)
class _Lengths:
    """The lengths of the received arrays. `what`: the noun for an element."""

    all: Sequence[int]
    wanted: int
    what: str

    @property
    def wrong(self) -> list[int]:
        return [n for n in self.all if n != self.wanted]

    @property
    def how_many(self) -> str:
        wrong, several = len(self.wrong), len(set(self.wrong)) > 1
        if wrong == len(self.all):
            return "the messages have" if several else "every message has"
        return f"{wrong} of {len(self.all)} messages {'has' if wrong == 1 else 'have'}"

    @property
    def lengths(self) -> str:
        different = sorted(set(self.wrong))
        if len(different) == 1:
            return count(different[0], self.what)
        return f"{listing([str(n) for n in different])} {self.what}s"

    @property
    def exactly(self) -> str:
        return count(self.wanted, self.what)


_LENGTH = WORDS.rules(
    _Lengths,
    "length",
    ("not-filled", lambda one: 0 in one.wrong),
    ("other-list", lambda one: all(abs(n - one.wanted) > 1 for n in one.wrong)),
    ("changes", lambda one: len(one.wrong) < len(one.all)),
    ("one-off", otherwise),
)


@if_all_kept
def length(recording: Recording, topic: Topic, wanted: int, what: str = "value") -> Verdict:
    """Check that every message contains an array of exactly `wanted` elements. `what`: the noun for an element."""
    lengths = _Lengths([length_of(value) for value in values(recording, topic)], wanted, what)
    if lengths.wrong:
        return _LENGTH.verdict(lengths)
    return passed(f"{lengths.exactly} in each of {count(len(lengths.all), 'message')}")


@dataclass(frozen=True)
class _Movement:
    """The changes of an array's elements from message to message. `what`: the noun for an element.

    Messages of an unusual length are ignored, and so are steps between messages that arrive at the same time.
    """

    recording: Recording
    topic: Topic
    at_least: int
    by: float
    what: str
    mostly: float = MOSTLY

    @cached_property
    def timed(self) -> list[tuple[float, list[Any]]]:
        arrivals = self.recording.topic(self.topic.name).arrivals
        return [(one.t, elements(one.value.get("data"))) for one in arrivals if isinstance(one.value, dict)]

    @property
    def messages(self) -> int:
        return len(self.timed)

    @cached_property
    def width(self) -> int:
        return statistics.mode(len(row) for _, row in self.timed)

    @cached_property
    def alike(self) -> list[tuple[float, list[Any]]]:
        return [(t, row) for t, row in self.timed if len(row) == self.width]

    @cached_property
    def moving(self) -> list[int]:
        """The indexes of the elements that change at some time during the recording."""
        return [place for place in range(self.width) if self._moves([row[place] for _, row in self.alike])]

    @cached_property
    def changed(self) -> list[int]:
        """The number of elements that change in each step."""
        at_once_s = PAIR_FRACTION * self.topic.period if self.topic.hz is not None else 0.0
        return [
            sum(self._moves([one, other]) for one, other in zip(before, after, strict=True))
            for (t, before), (then, after) in pairwise(self.alike)
            if then - t > at_once_s
        ]

    def _moves(self, column: list[Any]) -> bool:
        numbers = [value for value in column if isinstance(value, (int, float)) and math.isfinite(value)]
        return bool(numbers) and max(numbers) - min(numbers) > self.by

    @property
    def enough(self) -> bool:
        right = sum(n >= self.at_least for n in self.changed)
        return len(self.moving) >= self.at_least and right >= MOSTLY * len(self.changed)

    @property
    def wanted(self) -> str:
        return count(self.at_least, self.what)

    @property
    def steps(self) -> int:
        return len(self.changed)

    @property
    def still(self) -> int:
        """The number of steps in which nothing changes."""
        return self.changed.count(0)

    @property
    def hardly(self) -> int:
        """The number of steps in which too few elements change, including steps in which nothing changes."""
        return sum(n < self.at_least for n in self.changed)

    @property
    def few(self) -> int:
        return self.hardly - self.still


_OTHER_LENGTHS = WORDS.cause("varies.other-lengths", _Movement)
_ONE_MESSAGE = WORDS.cause("varies.one-message", _Movement, about_time=True)
_AT_REST = WORDS.rules(
    _Movement,
    "varies",
    ("none", lambda one: not one.moving),
    ("too-few", lambda one: len(one.moving) < one.at_least),
)
_TOO_LITTLE = WORDS.rules(
    _Movement,
    "varies",
    ("two-kinds", lambda one: 0 < one.still < one.hardly),
    ("stands-still", lambda one: one.still),
    ("one-at-a-time", otherwise),
)


@if_messages
def varies(recording: Recording, topic: Topic, at_least: int, by: float, what: str = "value") -> Verdict:
    """Check that at least `at_least` elements of the array change by more than `by` from message to message.

    That must be true for at least the fraction `MOSTLY` of these steps, so a movement may pause to reverse. Messages
    that arrive at the same time aren't compared, because `rate` judges that fault. `what`: the noun for an element.
    """
    seen = _Movement(recording, topic, at_least, by, what)
    if seen.enough:
        return passed(f"{len(seen.moving)} of {seen.width} {what}s move")
    if len(seen.alike) < 2 <= seen.messages:
        return _OTHER_LENGTHS.verdict(seen)
    if len(seen.alike) < 2:
        once = _ONE_MESSAGE.verdict(seen)
        return program_ended(recording, once.saw, once.expected) or once
    at_rest = _AT_REST.first(seen)
    compared = len(seen.alike) if at_rest else seen.steps + 1
    return replace(at_rest or _TOO_LITTLE.verdict(seen), about_time=compared < LEAST_MESSAGES)
