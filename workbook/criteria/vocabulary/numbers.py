"""Judges numbers that arrive on a topic."""

import math

from workbook.criteria.criterion import Topic
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.vocabulary.field_checks import quoting_field_checks, said_by_field_checks
from workbook.criteria.vocabulary.phrasing import count, number
from workbook.criteria.vocabulary.topics import if_messages
from workbook.criteria.vocabulary.values import first_offender, values
from workbook.recording.recording import Recording


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
    if not followed and (not seen or seen[0] != 0.0):
        return passed(
            f"numbers arrive as they are, the first is {number(seen[0])}" if seen else "no numbers in it"
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
    """If every number is 0.0, the program really sends 0.0: it does not put a value of a wrong type into the field."""
    seen = [value for value in values(recording, topic) if isinstance(value, (int, float))]
    if not seen or any(value != 0.0 for value in seen) or said_by_field_checks(recording) == "":
        return passed("its numbers are floats")
    return _zeros(recording, f"0.0 on {topic.name} in each of {count(len(seen), 'message')}")


def _zeros(recording: Recording, saw: str) -> Verdict:
    expected = "the number that your program wants to send, in every message"
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
    return failed(
        "really-arrives.wrong-type",
        saw,
        expected,
        quoting_field_checks(
            recording,
            "ROS does not check the type of a value in a message field. This build sends an int in a float field "
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
    bad = first_offender(
        recording,
        topic,
        lambda x: isinstance(x, (int, float)) and not low - slack <= x <= high + slack and x == x,
    )
    if bad is None:
        return passed(f"all values within {span}")
    saw = f"{number(bad.value)}{unit} in {bad}"
    limit = f"max({_bound(low, 'math.pi')}, min({_bound(high, 'math.pi')}, value))"

    def fail(cause: str, because: str, try_this: str = f"Limit it: {limit}.") -> Verdict:
        return failed(cause, saw, f"values from {span}", because, try_this)

    if math.isclose(high, math.pi) and abs(bad.value) <= 2 * math.pi:
        return fail("within.not-wrapped", "The angle keeps growing: it is neither limited nor wrapped at π.")
    if math.isclose(high, math.pi) and abs(bad.value) <= 360.0:
        return fail(
            "within.degrees",
            "Values above π look like degrees; angles in ROS are radians (REP 103).",
            f"math.radians() turns degrees into radians. Then limit them: {limit}.",
        )
    if math.isinf(bad.value):
        return fail(
            "within.infinite", "The value is infinite: a division by zero, or a number too large for 32 bits."
        )
    return fail("within.not-limited", "The simulated value is not limited.")


@if_messages
def never_rises(recording: Recording, topic: Topic, slack: float = 1e-4) -> Verdict:
    """No value is larger than the one before it (`slack` for rounding)."""
    numbers = [value for value in values(recording, topic) if isinstance(value, (int, float))]
    for index, (before, after) in enumerate(zip(numbers, numbers[1:], strict=False)):
        if after > before + slack:
            return failed(
                "never-rises.rises",
                f"{topic.name} rises from {number(before)} to {number(after)} at message {index + 2}",
                "a value that only falls",
                "The sign of the drain is wrong, or each message uses a new random number.",
                "Subtract from the level that the node stores.",
            )
    return passed(
        f"falls from {number(numbers[0])} to {number(numbers[-1])}" if len(numbers) > 1 else "never rises"
    )
