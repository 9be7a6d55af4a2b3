"""Matches inputs and outputs: which output of a program belongs to which message of the script.

Times are seconds of real time: from the moment an input was published to the moment its output was.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

from workbook.recording.recording import Arrival, Recording, Said

In = TypeVar("In")
Out = TypeVar("Out")


def said(recording: Recording, topic: str) -> list[Said]:
    """What the script published on `topic`, in order."""
    return [one for one in recording.said if one.topic == topic]


def script(recording: Recording, topic: str) -> list[Said]:
    """What the script has for `topic`, in order, with what was still to come when the watch ended."""
    return [one for one in (*recording.said, *recording.unsaid) if one.topic == topic]


def _same(one: Any, other: Any) -> bool:
    if isinstance(one, float) and isinstance(other, (int, float)):
        return abs(one - other) <= 1e-6 * max(1.0, abs(other))
    return bool(one == other)


def latencies(
    words: Sequence[Said], arrivals: Sequence[Arrival], *, field: str = "data"
) -> list[float | None]:
    """For each input: seconds until an output with the same value was published; None if none was.

    Both are told apart by the value of `field`, so let a script say every value once.
    """
    found: list[float | None] = []
    for word in words:
        wanted = word.value[field]
        times = [
            one.published
            for one in arrivals
            if _same(one.value.get(field), wanted) and one.published >= word.wall
        ]
        found.append(min(times) - word.wall if times else None)
    return found


@dataclass(frozen=True)
class Output:
    """One output of a program: its value, the value of the input that it belongs to, and how long after that it came.

    `of` is None and `after` (s) is infinite when it belongs to no input.
    """

    value: Any
    of: Any | None
    after: float


def outputs(
    words: Sequence[Said],
    arrivals: Sequence[Arrival],
    belongs: Callable[[Any, Any], bool] = _same,
    *,
    field: str = "data",
) -> list[Output]:
    """For each output, in the order of arrival: the first input that it belongs to.

    `belongs(output, input)` tells by the values of `field`; without it, equal values belong together.
    """
    found = []
    for arrival in arrivals:
        value = arrival.value[field]
        word = next((one for one in words if belongs(value, one.value[field])), None)
        if word is None:
            found.append(Output(value, None, math.inf))
        else:
            found.append(Output(value, word.value[field], arrival.published - word.wall))
    return found


def latest_before(inputs: Iterable[tuple[float, In]], published: float) -> In | None:
    """The input that came last before an output was published; None if none had come by then.

    `inputs`: each with the wall time (s) at which it came, such as `wall` of what `said` returns, in any order; of two
    with the same time the second one came last. `published`: wall time (s) of the output, `published` of an arrival.
    """
    earlier = sorted(((at, one) for at, one in inputs if at <= published), key=lambda pair: pair[0])
    return earlier[-1][1] if earlier else None


def pair_in_order(
    inputs: Sequence[In],
    outputs: Sequence[Out],
    *,
    belongs: Callable[[In, Out], bool],
    may_be_missing: Callable[[In], bool] = lambda _: False,
    may_be_extra: Callable[[Out], bool] = lambda _: False,
    excusable: Callable[[In], bool] = lambda _: False,
) -> list[tuple[In, Out]] | None:
    """Pairs inputs and outputs one by one, in their order; None when they do not fit.

    An input needs an output that belongs to it, unless it `may_be_missing` or is the only one that is `excusable`.
    What follows after the last pair must be outputs that `may_be_extra`.
    """

    def fit(i: int, j: int, excused: bool) -> list[tuple[In, Out]] | None:
        if i == len(inputs):
            return [] if all(may_be_extra(one) for one in outputs[j:]) else None
        if j < len(outputs) and belongs(inputs[i], outputs[j]):
            others = fit(i + 1, j + 1, excused)
            if others is not None:
                return [(inputs[i], outputs[j]), *others]
        if may_be_missing(inputs[i]):
            return fit(i + 1, j, excused)
        if not excused and excusable(inputs[i]):
            return fit(i + 1, j, True)
        return None

    return fit(0, 0, False)
