"""Judge numbers that arrive on a topic."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from workbook.criteria.criterion import Topic
from workbook.criteria.rules import Words, otherwise
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.field_checks import GIVEN, quoted_field_checks, said_by_field_checks
from workbook.criteria.vocabulary.phrasing import number
from workbook.criteria.vocabulary.topics import if_messages
from workbook.criteria.vocabulary.values import Offender, elements, first_offender, values
from workbook.recording.recording import Recording

WORDS = Words(__file__)

LEAST_OTHERS, STANDS_OUT = 4, 3.0
"""The conditions for a 0.0 to stand out among the other numbers (see `_zero_that_stands_out`).

There must be at least `LEAST_OTHERS` other numbers. The step between the 0.0 and its neighbor must be more than
`STANDS_OUT` times the largest step between two other numbers.
"""
RARELY = 0.25
"""If at most this fraction of the messages rise, the rises count as exceptions in a level that otherwise falls."""
_NOT_FINITE = WORDS.cause("finite.not-finite", ("bad",))
_ZERO = WORDS.cause("really-arrives.zero", ("topic", "where"), recheck_fields=True)
_ZERO_BY_TYPE = WORDS.seen("really-arrives.by-type", ("topic", "where"))
_RISE = ("topic", "before", "after", "place", "rises", "all")
_NOW_AND_THEN = WORDS.cause("never-rises.now-and-then", _RISE)
_RISES = WORDS.cause("never-rises.rises", _RISE)
_COMMA = WORDS.reason("wrong-type.comma", ("quoted",))
_KNOWN_TYPE = WORDS.reason("wrong-type.known", ("quoted",))
_UNKNOWN_TYPE = WORDS.reason("wrong-type.unknown", ("quoted",))


@if_messages
def finite(recording: Recording, topic: Topic) -> Verdict:
    """Check that no value is NaN or infinite."""
    bad = first_offender(recording, topic, lambda x: not (isinstance(x, (int, float)) and math.isfinite(x)))
    return passed("all values finite") if bad is None else _NOT_FINITE.verdict(bad=bad)


@if_messages
def really_arrives(recording: Recording, topic: Topic) -> Verdict:
    """Check that numbers arrive unchanged: the first one isn't 0.0, and no 0.0 is followed by another number.

    Use this for a quantity that starts above zero and never recovers from zero, such as a charge. A failure usually
    means that the program assigned a value that isn't a Python float. The message packages in these wheels send such a
    value as 0.0.
    """
    seen = [value for value in values(recording, topic) if isinstance(value, (int, float))]
    zeros = [place for place, value in enumerate(seen) if value == 0.0]
    followed = [place for place in zeros if any(value != 0.0 for value in seen[place:])]
    # If the field checks didn't find a wrong type, the zeros are intended. Other criteria judge a rise after them.
    meant = said_by_field_checks(recording) == "" and seen[:1] != [0.0]
    if meant or (not followed and (not seen or seen[0] != 0.0)):
        return passed(
            f"numbers arrive unchanged; the first is {number(seen[0])}" if seen else "no numbers in it"
        )
    if len(zeros) == len(seen):
        return _zeros(recording, topic, _in_all(seen))
    after = next(value for value in seen[followed[0] :] if value != 0.0)
    return _zeros(recording, topic, f"in message {followed[0] + 1}, and {number(after)} after it")


@if_messages
def given_floats(recording: Recording, topic: Topic) -> Verdict:
    """Check that zeros in a float field were really assigned as 0.0, and aren't values of a wrong type."""
    seen = [value for value in values(recording, topic) if isinstance(value, (int, float))]
    if not seen or said_by_field_checks(recording) == "":
        return passed("its numbers are floats")
    if not any(value != 0.0 for value in seen):
        return _zeros(recording, topic, _in_all(seen))
    stands_out = _zero_that_stands_out(seen)
    place = _zero_that_stays(seen) if stands_out is None else stands_out
    if place is None:
        return passed("its numbers are floats")
    beside = next(value for value in [*seen[place:], *reversed(seen[:place])] if value != 0.0)
    others = f"although other messages contain numbers such as {number(beside)}"
    return _zeros(recording, topic, f"in message {place + 1}, {others}")


def _zero_that_stands_out(seen: Sequence[float]) -> int | None:
    """Return the index of the first 0.0 that is unusually far from its neighbor, or None if there is none.

    Unusually far means `STANDS_OUT` times as far as any two other numbers in a row.
    """
    others = [value for value in seen if value != 0.0]
    if len(others) < LEAST_OTHERS:
        return None
    usual = max(
        (abs(after - before) for before, after in pairwise(seen) if before != 0.0 != after), default=0.0
    )
    jumps = (
        place if before != 0.0 else place - 1
        for place, (before, after) in enumerate(pairwise(seen), start=1)
        if (before == 0.0) != (after == 0.0) and abs(after - before) > STANDS_OUT * usual
    )
    return next(jumps, None)


def _zero_that_stays(seen: Sequence[float]) -> int | None:
    """Return the index of the first 0.0 after a topic's last other number, or None if it isn't followed by more zeros.

    One cause of such zeros is `max(0, level)`, which returns an int once the level is below zero.
    """
    last = max(place for place, value in enumerate(seen) if value != 0.0)
    return last + 1 if len(seen) - last > 2 else None


def _in_all(seen: Sequence[object]) -> str:
    """Return a phrase such as "in all 12 messages"."""
    return f"in all {len(seen)} messages" if len(seen) > 1 else "in the only message"


def _zeros(recording: Recording, topic: Topic, where: str) -> Verdict:
    said = said_by_field_checks(recording)
    if said == "":
        return _ZERO.verdict(topic=topic, where=where)
    known = _COMMA if "A comma at the end" in (said or "") else _KNOWN_TYPE
    why = known if GIVEN in (said or "") else _UNKNOWN_TYPE
    return failed(
        "really-arrives.wrong-type",
        *_ZERO_BY_TYPE(topic=topic, where=where),
        *why(quoted=quoted_field_checks(recording)),
        recheck_fields=True,
    )


def _bound(value: float, pi: str = "π") -> str:
    """Return a bound as a string, with ±π as the symbol, because a rounded π could be larger than π."""
    if math.isclose(abs(value), math.pi):
        return f"-{pi}" if value < 0 else pi
    return number(value)


@dataclass(frozen=True)
class _Outside:
    """The first value outside [low, high]. `unit` includes the space before it."""

    recording: Recording
    topic: Topic
    bad: Offender
    low: float
    high: float
    unit: str

    @property
    def value(self) -> str:
        return number(self.bad.value)

    @property
    def span(self) -> str:
        return f"{_bound(self.low)} to {_bound(self.high)}{self.unit}"

    @property
    def limit(self) -> str:
        return f"max({_bound(self.low, 'math.pi')}, min({_bound(self.high, 'math.pi')}, value))"

    def within_a_circle_of(self, circle: float) -> bool:
        return math.isclose(self.high, math.pi) and abs(self.bad.value) <= circle

    @cached_property
    def column(self) -> list[object]:
        """The values at the index of `bad`, taken from the message that contains `bad` and all later messages."""
        later = values(self.recording, self.topic)[self.bad.message - 1 :]
        return [(elements(value)[self.bad.place or 0 :] or [None])[0] for value in later]

    @property
    def keeps_growing(self) -> bool:
        """Whether the value keeps moving away from the range until the end of the recording."""
        sign = math.copysign(1.0, self.bad.value)
        numbers = [sign * value for value in self.column if isinstance(value, (int, float))]
        return all(before <= after for before, after in pairwise(numbers))

    @property
    def back_at_the_limit(self) -> bool:
        """Whether the value in the next message is exactly the limit that `bad` exceeded."""
        return self.column[1:2] == [self.low if self.bad.value < self.low else self.high]


_OUTSIDE = WORDS.rules(
    _Outside,
    "within",
    ("not-wrapped", lambda one: one.within_a_circle_of(2 * math.pi) and one.keeps_growing),
    ("beyond-pi", lambda one: one.within_a_circle_of(2 * math.pi)),
    ("degrees", lambda one: one.within_a_circle_of(360.0)),
    ("infinite", lambda one: math.isinf(one.bad.value)),
    ("limited-too-late", lambda one: one.back_at_the_limit),
    ("not-limited", otherwise),
)


@if_messages
def within(
    recording: Recording, topic: Topic, low: float, high: float, unit: str = "", slack: float = 1e-6
) -> Verdict:
    """Check that every value is in [low, high], up to `slack` for 32-bit rounding. NaN passes: use `finite` as well."""
    least, most = low - slack, high + slack
    bad = first_offender(recording, topic, lambda x: isinstance(x, (int, float)) and (x < least or x > most))
    unit = f" {unit}" if unit else ""
    if bad is None:
        return passed(f"all values within {_bound(low)} to {_bound(high)}{unit}")
    return _OUTSIDE.verdict(_Outside(recording, topic, bad, low, high, unit))


@if_messages
def never_rises(recording: Recording, topic: Topic, slack: float = 1e-4) -> Verdict:
    """Check that no value is larger than the previous one. `slack` allows for rounding."""
    numbers = [value for value in values(recording, topic) if isinstance(value, (int, float))]
    rises = [index for index, (before, after) in enumerate(pairwise(numbers)) if after > before + slack]
    if rises:
        before, after = numbers[rises[0] : rises[0] + 2]
        cause = _NOW_AND_THEN if len(rises) <= RARELY * len(numbers) else _RISES
        return cause.verdict(
            topic=topic,
            before=number(before),
            after=number(after),
            place=rises[0] + 2,
            rises=len(rises),
            all=len(numbers),
        )
    return passed(
        f"falls from {number(numbers[0])} to {number(numbers[-1])}" if len(numbers) > 1 else "never rises"
    )
