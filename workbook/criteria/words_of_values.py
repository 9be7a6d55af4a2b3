"""Words about the values that arrive on a topic."""

import math
import statistics
from collections.abc import Callable, Collection
from typing import Any

from workbook.criteria.criterion import Topic
from workbook.criteria.garbled import why_garbled
from workbook.criteria.phrasing import count, listing, number
from workbook.criteria.verdict import Verdict, failed, passed
from workbook.criteria.words_of_topics import no_message
from workbook.observing.recording import Recording

LEAST_MESSAGES = 3


def values(recording: Recording, topic: Topic, field: str = "data") -> list[Any]:
    """The values of one field of all messages that arrived."""
    return [
        arrival.value.get(field)
        for arrival in recording.topic(topic.name).arrivals
        if isinstance(arrival.value, dict)
    ]


def _array(value: Any) -> list[Any]:
    if isinstance(value, dict) and "first" in value:
        return list(value["first"])
    return value if isinstance(value, list) else [value]


def _array_length(value: Any) -> int:
    if isinstance(value, dict) and "length" in value:
        return int(value["length"])
    return len(_array(value))


def length(recording: Recording, topic: Topic, wanted: int, what: str = "value") -> Verdict:
    """Every message carries an array of exactly `wanted` elements."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    lengths = [_array_length(value) for value in values(recording, topic)]
    wrong = [n for n in lengths if n != wanted]
    if not wrong:
        return passed(f"{count(wanted, what)} in each of {count(len(lengths), 'message')}")
    kinds = listing([str(n) for n in sorted(set(wrong))])
    how_many = (
        "every message has" if len(wrong) == len(lengths) else f"{len(wrong)} of {len(lengths)} messages have"
    )
    reason = "Counting from 0 or from 1 gets one too many or one too few easily."
    if 0 in wrong:
        reason = "At least one message was published before its data was filled in."
    elif all(abs(n - wanted) > 1 for n in wrong):
        reason = "The list is built from something else than the joints, or grows with every message."
    return failed(
        f"{how_many} {kinds} {what}s",
        f"exactly {count(wanted, what)} in every message",
        reason,
        f"Print len(msg.data) before you publish; it must say {wanted}.",
    )


def _first_bad(
    recording: Recording, topic: Topic, bad: Callable[[Any], bool]
) -> tuple[int, int | None, Any, int] | None:
    """First offending value: message number, place in the array (None for a scalar), value, messages affected."""
    first: tuple[int, int | None, Any] | None = None
    affected = 0
    for index, value in enumerate(values(recording, topic)):
        elements = _array(value)
        places = [place for place, element in enumerate(elements) if bad(element)]
        if places:
            affected += 1
            if first is None:
                place = None if not isinstance(value, (list, dict)) else places[0]
                first = (index + 1, place, elements[places[0]])
    return None if first is None else (*first, affected)


def _place(message: int, place: int | None) -> str:
    return f"message {message}" if place is None else f"message {message}, element {place}"


def finite(recording: Recording, topic: Topic) -> Verdict:
    """No value is NaN or infinite."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    bad = _first_bad(recording, topic, lambda x: not (isinstance(x, (int, float)) and math.isfinite(x)))
    if bad is None:
        return passed("all values finite")
    message, place, value, affected = bad
    return failed(
        f"{value} in {_place(message, place)} ({count(affected, 'message')} affected)",
        "finite numbers only",
        "A division by zero, a square root or logarithm of a negative number, or a start value of NaN. "
        "A motor that receives NaN may do anything.",
        "Check with math.isfinite() before you publish.",
    )


def really_arrives(recording: Recording, topic: Topic) -> Verdict:
    """No message says 0.0 where the program means another number: not the first one, and none before another number.

    For a quantity that starts above zero and never comes back from it, such as a charge. What fails here is mostly a
    value that is no Python float: stock ROS sends it as 0.0.
    """
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    seen = [value for value in values(recording, topic) if isinstance(value, (int, float))]
    zeros = [place for place, value in enumerate(seen) if value == 0.0]
    followed = [place for place in zeros if any(value != 0.0 for value in seen[place:])]
    if not followed and (not seen or seen[0] != 0.0):
        return passed(
            f"numbers arrive as they are, the first is {number(seen[0])}" if seen else "no numbers in it"
        )
    if len(zeros) == len(seen):
        saw = f"0.0 on {topic.name} in each of {count(len(seen), 'message')}, from the first on"
    else:
        after = next(value for value in seen[followed[0] :] if value != 0.0)
        saw = f"0.0 on {topic.name} in message {followed[0] + 1}, and {number(after)} after it"
    return failed(
        saw,
        "the number that your program means, in every message",
        why_garbled(
            recording,
            "Stock ROS does not check what a field is given. In a float field an int is sent as 0.0, without a word; "
            "so are a str, None and np.float32.",
            "The program itself says 0.0: with field checks on, nothing of a wrong type was found in its messages.",
        ),
        "Give the field a float: float(level), 100.0 and not 100, and no int() or round() on the way.",
        garbled=True,
    )


def _bound(value: float, pi: str = "π") -> str:
    """A bound as one says it. Rounded, π would be a value beyond itself."""
    if math.isclose(abs(value), math.pi):
        return f"-{pi}" if value < 0 else pi
    return number(value)


def within(
    recording: Recording, topic: Topic, low: float, high: float, unit: str = "", slack: float = 1e-6
) -> Verdict:
    """Every value lies in [low, high]; `slack` allows for rounding to 32 bits. NaN is `finite`'s business."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    unit = f" {unit}" if unit else ""
    span = f"{_bound(low)} to {_bound(high)}{unit}"
    bad = _first_bad(
        recording,
        topic,
        lambda x: isinstance(x, (int, float)) and not low - slack <= x <= high + slack and x == x,
    )
    if bad is None:
        return passed(f"all values within {span}")
    message, place, value, affected = bad
    reason = "The simulated value is not limited."
    if math.isclose(high, math.pi) and abs(value) <= 2 * math.pi:
        reason = "The angle goes on turning: it is neither limited nor wrapped at π."
    elif math.isclose(high, math.pi) and abs(value) <= 360.0:
        reason = "Values above π look like degrees; angles in ROS are radians (REP 103)."
    elif math.isinf(value):
        reason = "Infinite: a division by zero, or a number too large for 32 bits."
    return failed(
        f"{number(value)}{unit} in {_place(message, place)} ({count(affected, 'message')} affected)",
        f"values from {span}",
        reason,
        f"Limit it: max({_bound(low, 'math.pi')}, min({_bound(high, 'math.pi')}, value))"
        + ("; math.radians() turns degrees into radians." if "degrees" in reason else "."),
    )


def varies(recording: Recording, topic: Topic, at_least: int, by: float, what: str = "value") -> Verdict:
    """At least `at_least` elements of the array change by more than `by` over the recording."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    rows = [_array(value) for value in values(recording, topic)]
    width = statistics.mode(len(row) for row in rows)
    rows = [row for row in rows if len(row) == width]
    moving = []
    for place in range(width):
        column = [
            row[place] for row in rows if isinstance(row[place], (int, float)) and math.isfinite(row[place])
        ]
        if column and max(column) - min(column) > by:
            moving.append(place)
    if len(moving) >= at_least:
        return passed(f"{len(moving)} of {width} {what}s move")
    saw = f"only {what} {moving[0]} moves" if moving else f"no {what} moves: every message is the same"
    reason = (
        "The values are set once, outside the callback; or the movement repeats with the period of the timer, so that "
        "each message catches the same pose."
        if not moving
        else "Only one element is ever changed."
    )
    if len(rows) < 2:
        saw, reason = (
            "a single message, so nothing can be seen to move",
            "The message is published only once.",
        )
    return failed(
        saw,
        f"at least {count(at_least, what)} that change from message to message (by more than {by:g})",
        reason,
        "Compute new angles in the timer callback, for example from math.sin of a counter.",
        about_time=len(rows) < LEAST_MESSAGES,
    )


def one_of(recording: Recording, topic: Topic, allowed: Collection[str]) -> Verdict:
    """Every text is one of the allowed words."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    words = listing([f'"{word}"' for word in sorted(allowed, reverse=True)]).replace(" and ", " or ")
    wrong = [
        value for value in values(recording, topic) if not isinstance(value, str) or value not in allowed
    ]
    if not wrong:
        said = sorted(set(map(str, values(recording, topic))))
        return passed("it says " + listing([f'"{word}"' for word in said]))
    text = str(wrong[0])[:60]
    reason = "Others compare this text letter by letter."
    if text == "":
        reason = (
            "Empty text: the message was published before its data was set, or a field name is misspelled."
        )
        reason = why_garbled(recording, reason, reason)
    return failed(
        f'"{text}" on {topic.name}', words, reason, f"Publish exactly one of {words}.", garbled=text == ""
    )


def never_rises(recording: Recording, topic: Topic, slack: float = 1e-4) -> Verdict:
    """No value is larger than the one before it (`slack` for rounding)."""
    nothing = no_message(recording, topic)
    if nothing is not None:
        return nothing
    numbers = [value for value in values(recording, topic) if isinstance(value, (int, float))]
    for index, (before, after) in enumerate(zip(numbers, numbers[1:], strict=False)):
        if after > before + slack:
            return failed(
                f"{topic.name} rises from {number(before)} to {number(after)} at message {index + 2}",
                "a value that only falls",
                "The sign of the drain is wrong, or each message starts from a fresh random number.",
                "Subtract from the level that the node remembers.",
            )
    return passed(
        f"falls from {number(numbers[0])} to {number(numbers[-1])}" if len(numbers) > 1 else "never rises"
    )
