"""Judges arrays that arrive on a topic."""

import math
import statistics
from itertools import pairwise
from typing import Any

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.estimators import PAIR_FRACTION
from workbook.criteria.vocabulary.phrasing import count, listing
from workbook.criteria.vocabulary.silences import program_ended
from workbook.criteria.vocabulary.topics import if_all_kept, if_messages
from workbook.criteria.vocabulary.values import elements, length_of, values
from workbook.recording.recording import Recording

LEAST_MESSAGES = 3
_NEW_ANGLES = (
    "Compute new angles in every call of the timer callback, for example from math.sin of a counter."
)
MOSTLY = 0.75
"""Share of the messages that differ from the one before as much as they must."""


@if_all_kept
def length(recording: Recording, topic: Topic, wanted: int, what: str = "value") -> Verdict:
    """Every message carries an array of exactly `wanted` elements."""
    lengths = [length_of(value) for value in values(recording, topic)]
    wrong = [n for n in lengths if n != wanted]
    if not wrong:
        return passed(f"{count(wanted, what)} in each of {count(len(lengths), 'message')}")
    kinds = listing([str(n) for n in sorted(set(wrong))])
    how_many = (
        "every message has" if len(wrong) == len(lengths) else f"{len(wrong)} of {len(lengths)} messages have"
    )

    def fail(cause: str, because: str) -> Verdict:
        return failed(
            cause,
            f"{how_many} {kinds} {what}s",
            f"exactly {count(wanted, what)} in every message",
            because,
            f"Print len(msg.data) before you publish. It must be {wanted}.",
        )

    if 0 in wrong:
        return fail("length.not-filled", "At least one message was published before its data was set.")
    if all(abs(n - wanted) > 1 for n in wrong):
        return fail(
            "length.other-list",
            "The list is not built from the joints, or it grows with every message.",
        )
    if len(wrong) < len(lengths):
        return fail(
            "length.changes",
            "Some messages have the right length, so only some calls add or omit an element.",
        )
    return fail(
        "length.one-off",
        "This is often an off-by-one error, such as a count that starts at 1 instead of 0.",
    )


@if_messages
def varies(recording: Recording, topic: Topic, at_least: int, by: float, what: str = "value") -> Verdict:
    """From message to message, at least `at_least` elements of the array change by more than `by`.

    Mostly: in a share of `MOSTLY` of the steps from one message to the next. A movement may turn around. Messages that
    come at one moment are not compared: that is a matter of the rate.
    """
    arrivals = [one for one in recording.topic(topic.name).arrivals if isinstance(one.value, dict)]
    timed = [(one.t, elements(one.value.get("data"))) for one in arrivals]
    width = statistics.mode(len(row) for _, row in timed)
    timed = [(t, row) for t, row in timed if len(row) == width]
    rows = [row for _, row in timed]
    moving = [place for place in range(width) if _moves([row[place] for row in rows], by)]
    at_once_s = PAIR_FRACTION * topic.period if topic.hz is not None else 0.0
    changed = [
        sum(_moves([one, other], by) for one, other in zip(before, after, strict=True))
        for (t, before), (then, after) in pairwise(timed)
        if then - t > at_once_s
    ]
    enough = sum(n >= at_least for n in changed)
    if len(moving) >= at_least and enough >= MOSTLY * len(changed):
        return passed(f"{len(moving)} of {width} {what}s move")
    expected = (
        f"at least {count(at_least, what)} that change by more than {by:g} from message to message, in at least "
        f"{MOSTLY:.0%} of the messages"
    )
    if len(rows) < 2 <= len(arrivals):
        return _other_lengths(len(arrivals), expected)
    once = "only one message, so no movement can be seen"
    ended = program_ended(recording, once, expected) if len(rows) < 2 else None
    return ended or _does_not_vary(len(rows), moving, changed, at_least, expected, what, f"to within {by:g}")


def _other_lengths(messages: int, expected: str) -> Verdict:
    return failed(
        "varies.other-lengths",
        f"{count(messages, 'message')} of different lengths, so they can't be compared",
        expected,
        "The number of values differs from message to message, so the judge can't tell which of them moved.",
        "First give every message the same number of values. Then make them move.",
    )


def _does_not_vary(
    messages: int, moving: list[int], changed: list[int], at_least: int, expected: str, what: str, exact: str
) -> Verdict:
    def at_rest(cause: str, saw: str, because: str) -> Verdict:
        return failed(
            cause,
            saw,
            expected,
            because,
            _NEW_ANGLES,
            about_time=messages < LEAST_MESSAGES,
        )

    if messages < 2:
        return at_rest(
            "varies.one-message",
            "only one message, so no movement can be seen",
            "The message is published only once.",
        )
    if not moving:
        return at_rest(
            "varies.none",
            f"no {what} moves: every message is the same, {exact}",
            "The values are set once, outside the callback. Or the movement repeats with the timer's period, so "
            "every message shows the same pose.",
        )
    if len(moving) < at_least:
        return at_rest("varies.too-few", f"only {what} {moving[0]} moves", "Only one element ever changes.")
    return _too_little_from_step_to_step(changed, at_least, expected, what, exact)


def _too_little_from_step_to_step(
    changed: list[int], at_least: int, expected: str, what: str, exact: str
) -> Verdict:
    """`changed`: how many elements change with each message after the first."""

    def too_little(cause: str, saw: str, because: str) -> Verdict:
        about_time = len(changed) + 1 < LEAST_MESSAGES
        return failed(cause, saw, expected, because, _NEW_ANGLES, about_time=about_time)

    still, hardly = changed.count(0), sum(n < at_least for n in changed)
    messages, fewer = count(len(changed), "message"), f"fewer than {count(at_least, what)}"
    if 0 < still < hardly:
        return too_little(
            "varies.two-kinds",
            f"of {messages}, {still} are the same as the previous one, {exact}, and {hardly - still} differ from it "
            f"in {fewer}",
            "Some calls publish the same values again, and others change too few of them.",
        )
    if still:
        return too_little(
            "varies.stands-still",
            f"{still} of {messages} are the same as the previous one, {exact}",
            "The movement ends, or some calls of the callback compute no new values.",
        )
    return too_little(
        "varies.one-at-a-time",
        f"{hardly} of {messages} differ from the previous one in {fewer}",
        "A call often changes too few elements, although other elements change in other calls.",
    )


def _moves(column: list[Any], by: float) -> bool:
    numbers = [value for value in column if isinstance(value, (int, float)) and math.isfinite(value)]
    return bool(numbers) and max(numbers) - min(numbers) > by
