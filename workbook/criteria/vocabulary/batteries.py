"""Judges a simulated battery: a charge in percent that begins full and falls, and a word that says when it is empty."""

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.numbers import never_rises
from workbook.criteria.vocabulary.phrasing import number, seconds
from workbook.criteria.vocabulary.topics import if_messages
from workbook.criteria.vocabulary.values import values
from workbook.recording.recording import Recording

FULL = 100.0
DROPS_BEFORE_THE_FIRST = 1.5
"""Of the largest drop that was seen: the first message may come after one drain, which may be a little larger."""
DROPS_MISSED_ON_THE_WALL_CLOCK = 4.0
"""The same where the program was found only when it had published already."""
ROUNDING = 1.0
HALVES_FROM = 8
"""So many messages tell whether a charge falls to the end. Fewer, and whole percents may stand still."""
WORKS, EMPTY = "operational", "error"


def _levels(recording: Recording, battery: Topic) -> list[float]:
    return [level for level in values(recording, battery) if isinstance(level, (int, float))]


@if_messages
def begins_full(recording: Recording, battery: Topic) -> Verdict:
    """The first charge is 100 %, or one step of draining below that."""
    levels = _levels(recording, battery)
    if not levels:
        return passed("no numbers in it")
    largest = max((before - after for before, after in pairwise(levels)), default=0.0)
    on_wall = recording.clock == "wall"
    drops = DROPS_MISSED_ON_THE_WALL_CLOCK if on_wall else DROPS_BEFORE_THE_FIRST
    first = levels[0]
    if first + drops * max(0.0, largest) >= FULL - ROUNDING:
        return passed(f"the first charge is {number(first)} %")
    saw = f"{number(first)} % in the first message"
    expected = "100 % in the first message, or one step of draining below that"
    if 0.0 < max(levels) <= 1.0:
        return failed(
            "begins-full.fraction",
            saw,
            expected,
            "The charge is a fraction, from 1 down to 0, not a percentage.",
            "Publish a percentage: multiply the fraction by 100, so that a full battery is 100.0.",
        )
    return failed(
        "begins-full.not-full",
        saw,
        expected,
        "The battery starts with another charge, or the published value is not the charge.",
        "Begin with self.battery_level = 100.0, and publish the level unchanged.",
    )


@if_messages
def drains(recording: Recording, battery: Topic) -> Verdict:
    """The charge falls until it is empty, and does not stop halfway through the recording."""
    levels = _levels(recording, battery)
    if len(levels) < 2 or levels[-1] == 0.0 < levels[0]:
        return passed("it drains")
    if levels[-1] >= levels[0]:
        return failed(
            "drains.never",
            f"{number(levels[0])} % in the first message and {number(levels[-1])} % in the last",
            "a battery that drains a little with every message",
            "The level is set once and never changed, or the new level isn't stored in self.",
            "Subtract a little from self.battery_level in the callback, then publish the new level.",
        )
    middle = levels[len(levels) // 2]
    if len(levels) >= HALVES_FROM and levels[-1] >= middle:
        return failed(
            "drains.stops",
            f"{number(levels[0])} % in the first message, but {number(middle)} % halfway through and "
            f"{number(levels[-1])} % at the end",
            "a battery that drains a little with every message",
            "The charge falls at first but then stops falling, because the drain depends on a condition or a "
            "counter.",
            "Subtract a little from self.battery_level in every call of the callback.",
        )
    return passed("it drains")


def word_fits_charge(recording: Recording, status: Topic, battery: Topic) -> Verdict:
    """The status is "operational" while the battery has charge, and "error" once it is empty.

    It may change from the last charge above 0 on, and must have changed by the second message that says 0: so it does
    not matter whether the charge is published before or after it is drained, and the clock plays no part. Where charges
    do not arrive as they are meant, nothing is said: that is another criterion's.
    """
    charges = [one for one in _data(recording, battery) if isinstance(one.data, (int, float))]
    words = _data(recording, status)
    above = [one for one in charges if one.data > 0.0]
    zeros = [one for one in charges if one.data == 0.0]
    fine = above and charges[0].data > 0.0 and never_rises(recording, battery).ok
    if not fine or not drains(recording, battery).ok:
        return passed("the charge is judged elsewhere")
    charged = [one for one in words if one.order < above[-1].order]
    early = next((one for one in charged if one.data == EMPTY), None)
    if early is not None:
        level = next((one.data for one in reversed(charges) if one.order < early.order), charges[0].data)
        after = [one.data for one in charged if one.order > early.order]
        return _error_while_charged(early.t, level, before=charged[0].data == WORKS, back=WORKS in after)
    late = [one for one in words if one.data == WORKS and zeros[1:] and one.order > zeros[1].order]
    if late:
        said = [one.data for one in words if one.order > zeros[0].order]
        return _no_error_when_empty(late[0].t, zeros[0].t, said)
    return passed('"error" when the battery was empty, and not before' if zeros else "the battery had charge")


@dataclass(frozen=True)
class _Said:
    """What a message said, and when: `order` by the stamp of its publisher, `t` in s of simulated time."""

    order: float
    t: float
    data: Any


def _data(recording: Recording, topic: Topic) -> list[_Said]:
    arrivals = [one for one in recording.topic(topic.name).arrivals if isinstance(one.value, dict)]
    said = [_Said(one.published, one.t, one.value.get("data")) for one in arrivals]
    return sorted(said, key=lambda one: one.order)


def _error_while_charged(at: float, level: float, *, before: bool, back: bool) -> Verdict:
    saw = f'"error" at {seconds(at)}, while the battery is at {number(level)} %'
    expected = '"operational" while the battery has charge, and "error" once it is empty'
    try_this = 'Use the level itself: "operational" if self.battery_level > 0.0 else "error".'
    if back:
        return failed(
            "word-fits-charge.changes",
            f'{saw}, and "operational" again after that',
            expected,
            "The word depends on something other than the charge, such as chance or a counter.",
            try_this,
        )
    if before:
        return failed(
            "word-fits-charge.too-early",
            saw,
            expected,
            "The threshold isn't 0. A low battery isn't empty yet.",
            try_this,
        )
    return failed(
        "word-fits-charge.turned-around",
        saw,
        expected,
        "The condition is reversed, or it tests a level other than the published one.",
        try_this,
    )


def _no_error_when_empty(at: float, empty_at: float, said: list[Any]) -> Verdict:
    """`said`: the words after the battery was empty."""
    saw = f'"operational" at {seconds(at)}, though the battery has been at 0 % since {seconds(empty_at)}'
    expected = '"operational" while the battery has charge, and "error" once it is empty'
    try_this = 'Use the level itself: "operational" if self.battery_level > 0.0 else "error".'
    if EMPTY not in said:
        return failed(
            "word-fits-charge.never-error",
            saw,
            expected,
            "The word does not depend on the charge, or it depends on a level that never reaches 0.",
            try_this,
        )
    if WORKS in said[said.index(EMPTY) :]:
        return failed(
            "word-fits-charge.error-not-kept",
            f'{saw}; "error" was also published',
            expected,
            'The status doesn\'t stay at "error" while the battery is empty. It depends on something else, such as '
            "a counter.",
            try_this,
        )
    return failed(
        "word-fits-charge.too-late",
        f'{saw}; "error" was published only after that',
        expected,
        "The word changes too late: it depends on an older level, or on a different level that reaches 0 later.",
        try_this,
    )
