"""Extract the values from a topic's messages."""

import functools
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from workbook.criteria.criterion import Topic
from workbook.criteria.vocabulary.phrasing import count
from workbook.recording.recording import Recording

Found = TypeVar("Found")


def once(look: Callable[[Recording], Found]) -> Callable[[Recording], Found]:
    """Make a function inspect a recording only once, even if several criteria need its result.

    Don't modify the function's result, because later calls return the same object.
    """
    latest: tuple[Recording, Found] | None = None

    @functools.wraps(look)
    def found(recording: Recording) -> Found:
        nonlocal latest
        known = latest
        if known is None or known[0] is not recording:
            known = latest = recording, look(recording)
        return known[1]

    return found


def values(recording: Recording, topic: Topic, field: str = "data") -> list[Any]:
    """Return the values of one field from all messages that arrived, in order."""
    return [
        arrival.value.get(field)
        for arrival in recording.topic(topic.name).arrivals
        if isinstance(arrival.value, dict)
    ]


def part_of(recording: Recording, topic: Topic, keep: Callable[[Any], bool]) -> Recording:
    """Return the recording with only those messages of `topic` for whose data `keep` returns True.

    The topic's watch then begins with the first of these messages. Use this for a topic with several publishers, some
    of which may connect later than others.
    """
    seen = recording.topic(topic.name)
    kept = tuple(
        arrival
        for arrival in seen.arrivals
        if isinstance(arrival.value, dict) and keep(arrival.value.get("data"))
    )
    end = recording.watched_s if seen.window is None else seen.window[1]
    window = (kept[0].t, end) if kept else seen.window
    part = replace(seen, arrivals=kept, window=window)
    return replace(recording, topics={**recording.topics, topic.name: part})


def elements(value: Any) -> list[Any]:
    """Return an array's elements, or a single value as a list.

    Of a very long array, the recording keeps only the first elements.
    """
    if isinstance(value, dict) and "first" in value:
        return list(value["first"])
    return value if isinstance(value, list) else [value]


def length_of(value: Any) -> int:
    """Return the length of an array, even if the recording keeps only its first elements."""
    if isinstance(value, dict) and "length" in value:
        return int(value["length"])
    return len(elements(value))


@dataclass(frozen=True)
class Offender:
    """The first value that breaks a rule. `message`: the number of its message, from 1.

    `place`: the value's index in the array, or None for a scalar. `affected`: the number of messages with such a value.
    """

    message: int
    place: int | None
    value: Any
    affected: int

    def __str__(self) -> str:
        where = f"message {self.message}" + ("" if self.place is None else f", element {self.place}")
        return f"{where} ({count(self.affected, 'message')} affected)"


def first_offender(recording: Recording, topic: Topic, breaks: Callable[[Any], bool]) -> Offender | None:
    """Return the first value or array element for which `breaks` returns True, or None if there is none."""
    first: tuple[int, int | None, Any] | None = None
    affected = 0
    for number, value in enumerate(values(recording, topic), start=1):
        parts = elements(value)
        places = [place for place, element in enumerate(parts) if breaks(element)]
        if places:
            affected += 1
            if first is None:
                place = None if not isinstance(value, (list, dict)) else places[0]
                first = (number, place, parts[places[0]])
    return None if first is None else Offender(*first, affected)
