"""Judges numbers that arrive on a topic."""

import math
from collections.abc import Sequence
from itertools import pairwise

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.field_checks import GIVEN, quoting_field_checks, said_by_field_checks
from workbook.criteria.vocabulary.phrasing import count, number
from workbook.criteria.vocabulary.topics import if_messages
from workbook.criteria.vocabulary.values import Offender, elements, first_offender, values
from workbook.recording.recording import Recording

LEAST_OTHERS, STANDS_OUT = 4, 3.0
"""A 0.0 among at least so many other numbers stands out if it is so many of their largest steps away from one."""
RARELY = 0.25
"""Up to this share of messages, a rise is an exception: the level falls otherwise."""


@if_messages
def finite(recording: Recording, topic: Topic) -> Verdict:
    """No value is NaN or infinite."""
    bad = first_offender(recording, topic, lambda x: not (isinstance(x, (int, float)) and math.isfinite(x)))
    if bad is None:
        return passed("all values finite")
    return failed(
        "finite.not-finite",
        f"{bad.value} in {bad}",
        "finite numbers only",
        "The cause is a division by zero, a root or logarithm of a negative number, or a start value of NaN. A "
        "motor that receives NaN may do anything.",
        "Check with math.isfinite() before you publish.",
    )


@if_messages
def really_arrives(recording: Recording, topic: Topic) -> Verdict:
    """Numbers arrive as they are: the first one is not 0.0, and no 0.0 is followed by another number.

    For a quantity that starts above zero and never comes back from it, such as a charge. The usual cause of a failure
    is a value that is no Python float: the message packages of these wheels send it as 0.0.
    """
    seen = [value for value in values(recording, topic) if isinstance(value, (int, float))]
    zeros = [place for place, value in enumerate(seen) if value == 0.0]
    followed = [place for place in zeros if any(value != 0.0 for value in seen[place:])]
    meant = said_by_field_checks(recording) == "" and seen[:1] != [0.0]  # that it rises again, others judge
    if meant or (not followed and (not seen or seen[0] != 0.0)):
        return passed(
            f"numbers arrive unchanged; the first is {number(seen[0])}" if seen else "no numbers in it"
        )
    if len(zeros) == len(seen):
        return _zeros(
            recording, f"0.0 on {topic.name} in each of {count(len(seen), 'message')}, from the first on"
        )
    after = next(value for value in seen[followed[0] :] if value != 0.0)
    return _zeros(
        recording, f"0.0 on {topic.name} in message {followed[0] + 1}, and {number(after)} after it"
    )


@if_messages
def given_floats(recording: Recording, topic: Topic) -> Verdict:
    """Whether a program whose numbers are all 0.0 sends 0.0, or puts a value of a wrong type into the field."""
    seen = [value for value in values(recording, topic) if isinstance(value, (int, float))]
    if not seen or said_by_field_checks(recording) == "":
        return passed("its numbers are floats")
    if not any(value != 0.0 for value in seen):
        return _zeros(recording, f"0.0 on {topic.name} in each of {count(len(seen), 'message')}")
    stands_out = _zero_that_stands_out(seen)
    place = _zero_that_stays(seen) if stands_out is None else stands_out
    if place is None:
        return passed("its numbers are floats")
    beside = next(value for value in [*seen[place:], *reversed(seen[:place])] if value != 0.0)
    return _zeros(recording, f"0.0 on {topic.name} in message {place + 1}, next to {number(beside)}")


def _zero_that_stands_out(seen: Sequence[float]) -> int | None:
    """The place of the first 0.0 that is much farther from its neighbors than all others are from theirs."""
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
    """The place of the first of several 0.0 that end a topic with other numbers: `max(0, level)` makes an int of it."""
    last = max(place for place, value in enumerate(seen) if value != 0.0)
    return last + 1 if len(seen) - last > 2 else None


def _zeros(recording: Recording, saw: str) -> Verdict:
    expected = "the number that your program means to send, in every message"
    try_this = (
        "Give the field a float: float(level), or 100.0 instead of 100. Do not use int() or round() first."
    )
    if said_by_field_checks(recording) == "":
        return failed(
            "really-arrives.zero",
            saw,
            expected,
            "The program itself sends 0.0: field checks found no value of a wrong type in its messages.",
            try_this,
            recheck_fields=True,
        )
    said = said_by_field_checks(recording) or ""
    if "A comma at the end" in said:
        try_this = "Remove the comma after the value. It makes a tuple."
    return failed(
        "really-arrives.wrong-type",
        saw,
        expected,
        quoting_field_checks(
            recording,
            "ROS does not check the type of a value in a message field. This build sends a value of another type in "
            "a float field as 0.0, and reports no error. The Ubuntu packages may abort the program instead."
            if GIVEN in said
            else "ROS does not check the type of a value in a message field. This build sends an int in a float field "
            "as 0.0, and reports no error. The same happens to a str, None and np.float32. The Ubuntu packages "
            "may abort the program instead.",
        ),
        try_this,
        recheck_fields=True,
    )


def _bound(value: float, pi: str = "π") -> str:
    """A bound as one says it. Rounded, π would be a value beyond itself."""
    if math.isclose(abs(value), math.pi):
        return f"-{pi}" if value < 0 else pi
    return number(value)


@if_messages
def within(
    recording: Recording, topic: Topic, low: float, high: float, unit: str = "", slack: float = 1e-6
) -> Verdict:
    """Every value lies in [low, high]; `slack` allows for rounding to 32 bits. NaN is left to `finite`."""
    unit = f" {unit}" if unit else ""
    span = f"{_bound(low)} to {_bound(high)}{unit}"
    least, most = low - slack, high + slack
    bad = first_offender(recording, topic, lambda x: isinstance(x, (int, float)) and (x < least or x > most))
    if bad is None:
        return passed(f"all values within {span}")
    saw = f"{number(bad.value)}{unit} in {bad}"
    limit = f"max({_bound(low, 'math.pi')}, min({_bound(high, 'math.pi')}, value))"

    def fail(cause: str, because: str, try_this: str = f"Limit it: {limit}.") -> Verdict:
        return failed(cause, saw, f"values from {span}", because, try_this)

    if math.isclose(high, math.pi) and abs(bad.value) <= 2 * math.pi:
        if _keeps_growing(recording, topic, bad):
            return fail(
                "within.not-wrapped", "The angle keeps growing: it is neither limited nor wrapped at π."
            )
        return fail(
            "within.beyond-pi",
            "The angle goes beyond π: the movement is too wide, or angles are counted from 0 to 2π.",
        )
    if math.isclose(high, math.pi) and abs(bad.value) <= 360.0:
        return fail(
            "within.degrees",
            "Values above π look like degrees; angles in ROS are radians (REP 103).",
            f"math.radians() turns degrees into radians. Then limit them: {limit}.",
        )
    if math.isinf(bad.value):
        return fail(
            "within.infinite",
            "The value is infinite: a division by zero, or a number too large for 32 bits.",
        )
    if _back_at(recording, topic, bad) != (low if bad.value < low else high):
        return fail("within.not-limited", "The simulated value is not limited.")
    because = "The value is limited, but only after it was published: the next message is at the limit."
    return fail("within.limited-too-late", because, f"Limit it first, then publish it: {limit}.")


def _back_at(recording: Recording, topic: Topic, bad: Offender) -> object:
    """What the message after the one with this offender says in its place; None if there is none."""
    after = [elements(value)[bad.place or 0 :][:1] for value in values(recording, topic)[bad.message :]]
    return after[0][0] if after and after[0] else None


def _keeps_growing(recording: Recording, topic: Topic, bad: Offender) -> bool:
    """Whether a value moves on in the direction in which it left its range, until the end."""
    sign = math.copysign(1.0, bad.value)
    column = [elements(value)[bad.place or 0 :][:1] for value in values(recording, topic)[bad.message - 1 :]]
    numbers = [sign * one[0] for one in column if one and isinstance(one[0], (int, float))]
    return all(before <= after for before, after in pairwise(numbers))


@if_messages
def never_rises(recording: Recording, topic: Topic, slack: float = 1e-4) -> Verdict:
    """No value is larger than the one before it (`slack` for rounding)."""
    numbers = [value for value in values(recording, topic) if isinstance(value, (int, float))]
    rises = [index for index, (before, after) in enumerate(pairwise(numbers)) if after > before + slack]
    if rises:
        before, after = numbers[rises[0] : rises[0] + 2]
        saw = f"{topic.name} rises from {number(before)} to {number(after)} at message {rises[0] + 2}"
        if len(rises) <= RARELY * len(numbers):
            return failed(
                "never-rises.now-and-then",
                f"{saw} ({len(rises)} of {count(len(numbers), 'message')})",
                "a value that only falls",
                "The level doesn't rise in most messages, so something occasionally adds to it or resets it.",
                "Only subtract from the level that the node stores, even when it's low or empty.",
            )
        return failed(
            "never-rises.rises",
            saw,
            "a value that only falls",
            "The sign of the drain is wrong, or each message uses a new random number.",
            "Subtract from the level that the node stores.",
        )
    return passed(
        f"falls from {number(numbers[0])} to {number(numbers[-1])}" if len(numbers) > 1 else "never rises"
    )
