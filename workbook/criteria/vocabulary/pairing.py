"""Match a program's outputs with the script's messages that they respond to.

Times are in seconds of real time, from the publication of an input to the publication of its output.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TypeVar

from workbook.recording.recording import Published, Recording

In = TypeVar("In")
Out = TypeVar("Out")


def published(recording: Recording, topic: str) -> list[Published]:
    """Return the script's messages that were published on `topic`, in order."""
    return [one for one in recording.published if one.topic == topic]


def script(recording: Recording, topic: str) -> list[Published]:
    """Return the script's messages for `topic`, in order.

    Messages that were still unpublished when the watch ended are included.
    """
    return [one for one in (*recording.published, *recording.unpublished) if one.topic == topic]


def latest_before(inputs: Iterable[tuple[float, In]], published: float) -> In | None:
    """Return the last input before an output was published, or None if there was none.

    `inputs`: pairs of a wall time (s) and an input, in any order. For messages from the function `published`, use their
    `wall` as the time. Of two inputs with equal times, the second counts as later. `published`: the wall time (s) at
    which the output was published, such as an arrival's `published`.
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
    """Pair inputs with outputs, one to one and in order. Return the pairs, or None if that's impossible.

    Every input needs an output that `belongs` to it, unless `may_be_missing` is true for that input. In addition, one
    input for which `excusable` is true may lack an output. Outputs after the last pair must satisfy `may_be_extra`.
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


# Sets of outputs are integers. Bit j stands for outputs[j], or means that exactly the first j outputs can be paired.
_Row = tuple[int, bool, bool]
"""For one input: the outputs that belong to it, whether it may lack an output, and whether its lack can be excused."""


def _looked_up(
    inputs: Sequence[In],
    outputs: Sequence[Out],
    belongs: Callable[[In, Out], bool],
    may_be_missing: Callable[[In], bool],
    excusable: Callable[[In], bool],
) -> list[_Row] | None:
    """Return a row for each input, limited to outputs that can be reached.

    An output can be reached if all earlier inputs and outputs can be paired. Return None if an input can't reach any
    output.
    """
    # The numbers of outputs with which the inputs so far can be paired: without the excuse, and after using it.
    plain, excused = 1, 0
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
    """Return, for each input, the positions in the outputs from which the inputs after it can be paired.

    Each entry has the positions while the excuse is still available, and the positions after the excuse was used. The
    result is None if the inputs can't be paired from the start.

    `outputs`: the number of outputs. `last`: the index from which on all outputs may be extra.
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
    """Return the positions of a number's 1 bits, lowest first."""
    lowest = (number & -number).bit_length() - 1
    digits = bin(number >> lowest)[:1:-1]
    return (place for place, digit in enumerate(digits, lowest) if digit == "1")
