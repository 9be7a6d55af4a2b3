"""Matches inputs and outputs: which output of a program belongs to which message of the script.

Times are seconds of real time: from the moment an input was published to the moment its output was.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

from workbook.recording.recording import Arrival, Published, Recording

In = TypeVar("In")
Out = TypeVar("Out")


def published(recording: Recording, topic: str) -> list[Published]:
    """What the script published on `topic`, in order."""
    return [one for one in recording.published if one.topic == topic]


def script(recording: Recording, topic: str) -> list[Published]:
    """What the script has for `topic`, in order, with what was still to come when the watch ended."""
    return [one for one in (*recording.published, *recording.unpublished) if one.topic == topic]


def _same(one: Any, other: Any) -> bool:
    if isinstance(one, float) and isinstance(other, (int, float)):
        return abs(one - other) <= 1e-6 * max(1.0, abs(other))
    return bool(one == other)


def latencies(
    words: Sequence[Published], arrivals: Sequence[Arrival], *, field: str = "data"
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
    words: Sequence[Published],
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

    `inputs`: each with the wall time (s) at which it came, such as `wall` of what `published` returns, in any order; of
    two with the same time the second one came last. `published`: wall time (s) of the output, `published` of an
    arrival.
    """
    latest = None
    for at, one in inputs:
        if at <= published and (latest is None or at >= latest[0]):
            latest = at, one
    return None if latest is None else latest[1]


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
    table = _looked_up(inputs, outputs, belongs, may_be_missing, excusable)
    last = len(outputs)
    while last > 0 and may_be_extra(outputs[last - 1]):
        last -= 1
    fits = None if table is None else _from_where_it_fits(table, len(outputs), last)
    if table is None or fits is None:
        return None
    pairs: list[tuple[In, Out]] = []
    used = 0
    for one, (mine, missing, _), rest in zip(inputs, table, fits, strict=True):
        j = len(pairs)
        if mine >> j & 1 and rest[used] >> j + 1 & 1:
            pairs.append((one, outputs[j]))
        elif not missing:
            used = 1
    return pairs


# Sets of outputs are whole numbers: bit j is outputs[j], or says that the first j outputs can be paired.
_Row = tuple[int, bool, bool]
"""Of an input: the outputs that belong to it, whether it may be missing, and whether it can be the excused one."""


def _looked_up(
    inputs: Sequence[In],
    outputs: Sequence[Out],
    belongs: Callable[[In, Out], bool],
    may_be_missing: Callable[[In], bool],
    excusable: Callable[[In], bool],
) -> list[_Row] | None:
    """A row for each input, for the outputs that can be reached; None when none can be reached any more."""
    plain, excused = 1, 0  # reached by the inputs so far: without an excuse, and with the only one
    table = []
    for one in inputs:
        places = (j for j in _bits_of(plain | excused) if j < len(outputs) and belongs(one, outputs[j]))
        mine, missing = sum(1 << j for j in places), may_be_missing(one)
        excuse = not missing and plain != 0 and excusable(one)
        table.append((mine, missing, excuse))
        plain, excused = (
            (plain & mine) << 1 | plain * missing,
            (excused & mine) << 1 | excused * missing | plain * excuse,
        )
        if not plain | excused:
            return None
    return table


def _from_where_it_fits(table: Sequence[_Row], outputs: int, last: int) -> list[tuple[int, int]] | None:
    """After each input: from where the rest can be paired, without an excuse and with it. None if the whole cannot.

    `last`: from there on, all of the `outputs` may be extra.
    """
    plain = excused = (1 << outputs + 1) - (1 << last)
    fits = []
    for mine, missing, excuse in reversed(table):
        fits.append((plain, excused))
        plain, excused = (
            (plain >> 1 & mine) | plain * missing | excused * excuse,
            (excused >> 1 & mine) | excused * missing,
        )
    return fits[::-1] if plain & 1 else None


def _bits_of(number: int) -> Iterator[int]:
    """The places of its bits that are 1, from the lowest one."""
    lowest = (number & -number).bit_length() - 1
    digits = bin(number >> lowest)[:1:-1]
    return (place for place, digit in enumerate(digits, lowest) if digit == "1")
