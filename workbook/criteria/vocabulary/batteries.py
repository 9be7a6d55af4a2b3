"""Judge a simulated battery: a charge (%) that starts full and falls, and a status that reports an empty battery."""

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

from workbook.criteria.criterion import Topic
from workbook.criteria.rules import Words
from workbook.criteria.verdict import Verdict, passed
from workbook.criteria.vocabulary.numbers import never_rises
from workbook.criteria.vocabulary.phrasing import number
from workbook.criteria.vocabulary.topics import if_messages
from workbook.criteria.vocabulary.values import values
from workbook.recording.recording import Recording

WORDS = Words(__file__)

FULL = 100.0
DROPS_BEFORE_THE_FIRST = 1.5
"""The most by which the first charge may be below 100 %, as a multiple of the largest drop between two messages.

The program may drain the battery once before its first message, by slightly more than that drop.
"""
DROPS_MISSED_ON_THE_WALL_CLOCK = 4.0
"""The same factor for the wall clock, on which the judge may miss a program's first messages."""
ROUNDING = 1.0
HALVES_FROM = 8
"""The least messages that show that a charge has stopped falling. In fewer, a whole-percent charge may just repeat."""
WORKS, EMPTY = "operational", "error"


_FRACTION = WORDS.cause("begins-full.fraction", ("first",))
_NOT_FULL = WORDS.cause("begins-full.not-full", ("first",))
_NEVER = WORDS.cause("drains.never", ("first", "last"))
_STOPS = WORDS.cause("drains.stops", ("first", "middle", "last"))


@dataclass(frozen=True)
class _Said:
    """A message's data, the time of publication (`order`; wall time, s), and of arrival (`t`; simulated time, s)."""

    order: float
    t: float
    data: Any


@dataclass(frozen=True)
class _Words:
    """The status words and the charges, each in the order in which they were published."""

    words: list[_Said]
    charges: list[_Said]

    @cached_property
    def above(self) -> list[_Said]:
        return [one for one in self.charges if one.data > 0.0]

    @cached_property
    def zeros(self) -> list[_Said]:
        return [one for one in self.charges if one.data == 0.0]

    @cached_property
    def charged(self) -> list[_Said]:
        """The status words that were published before the last charge above 0."""
        return [one for one in self.words if one.order < self.above[-1].order]

    @cached_property
    def early(self) -> _Said | None:
        """The first "error" among the words in `charged`."""
        return next((one for one in self.charged if one.data == EMPTY), None)

    @property
    def level(self) -> str:
        """The last charge before the early "error", or the first charge if none was published before."""
        before = [one.data for one in self.charges if self.early and one.order < self.early.order]
        return number(before[-1] if before else self.charges[0].data)

    @property
    def back(self) -> bool:
        """Whether the status changed back to "operational" after an early "error"."""
        return any(self.early and one.order > self.early.order and one.data == WORKS for one in self.charged)

    @cached_property
    def late(self) -> _Said | None:
        """The first "operational" after the second charge of 0."""
        late = (one for one in self.words if one.data == WORKS and one.order > self.zeros[1].order)
        return next(late, None) if self.zeros[1:] else None

    @property
    def empty_at(self) -> float:
        return self.zeros[0].t

    @property
    def said(self) -> list[Any]:
        """The status words after the first charge of 0."""
        return [one.data for one in self.words if one.order > self.zeros[0].order]


_MISFITS = WORDS.rules(
    _Words,
    "word-fits-charge",
    ("changes", lambda one: one.early and one.back),
    ("too-early", lambda one: one.early and one.charged[0].data == WORKS),
    ("turned-around", lambda one: one.early),
    ("never-error", lambda one: one.late and EMPTY not in one.said),
    ("error-not-kept", lambda one: one.late and WORKS in one.said[one.said.index(EMPTY) :]),
    ("too-late", lambda one: one.late),
)


def _levels(recording: Recording, battery: Topic) -> list[float]:
    return [level for level in values(recording, battery) if isinstance(level, (int, float))]


@if_messages
def begins_full(recording: Recording, battery: Topic) -> Verdict:
    """Check that the first charge is 100 %, or lower by what the battery loses between two messages."""
    levels = _levels(recording, battery)
    if not levels:
        return passed("no numbers in it")
    largest = max((before - after for before, after in pairwise(levels)), default=0.0)
    drops = DROPS_MISSED_ON_THE_WALL_CLOCK if recording.clock == "wall" else DROPS_BEFORE_THE_FIRST
    if levels[0] + drops * max(0.0, largest) >= FULL - ROUNDING:
        return passed(f"the first charge is {number(levels[0])} %")
    return (_FRACTION if 0.0 < max(levels) <= 1.0 else _NOT_FULL).verdict(first=number(levels[0]))


@if_messages
def drains(recording: Recording, battery: Topic) -> Verdict:
    """Check that the charge falls until the battery is empty, and keeps falling in the recording's second half."""
    levels = _levels(recording, battery)
    if len(levels) < 2 or levels[-1] == 0.0 < levels[0]:
        return passed("it drains")
    first, middle, last = levels[0], levels[len(levels) // 2], levels[-1]
    if last >= first:
        return _NEVER.verdict(first=number(first), last=number(last))
    if len(levels) >= HALVES_FROM and last >= middle:
        return _STOPS.verdict(first=number(first), middle=number(middle), last=number(last))
    return passed("it drains")


def word_fits_charge(recording: Recording, status: Topic, battery: Topic) -> Verdict:
    """Check that the status is "operational" while the battery has charge, and "error" once the battery is empty.

    The status may change any time after the last charge above 0, and must have changed by the second charge of 0. So
    the program may publish the charge before or after draining the battery, on either clock. If the charges themselves
    are wrong, this check passes, because other criteria judge the charges.
    """
    charges = [one for one in _data(recording, battery) if isinstance(one.data, (int, float))]
    seen = _Words(_data(recording, status), charges)
    fine = seen.above and charges[0].data > 0.0 and never_rises(recording, battery).ok
    if not fine or not drains(recording, battery).ok:
        return passed("the charge is judged elsewhere")
    fits = '"error" when the battery was empty, and not before' if seen.zeros else "the battery had charge"
    return _MISFITS.first(seen) or passed(fits)


def _data(recording: Recording, topic: Topic) -> list[_Said]:
    arrivals = [one for one in recording.topic(topic.name).arrivals if isinstance(one.value, dict)]
    said = [_Said(one.published, one.t, one.value.get("data")) for one in arrivals]
    return sorted(said, key=lambda one: one.order)
