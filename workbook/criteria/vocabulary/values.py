"""The values that arrive on a topic, taken out of its messages."""

import functools
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, TypeVar

from workbook.criteria.criterion import Topic
from workbook.criteria.vocabulary.phrasing import count
from workbook.recording.recording import Recording

Found = TypeVar("Found")


def once(look: Callable[[Recording], Found]) -> Callable[[Recording], Found]:
    """Make a function look at a recording only once, however many criteria ask for what it finds.

    What it returns must not be changed: it is the same object each time.
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
    """The values of one field of all messages that arrived, in order."""
    return [
        arrival.value.get(field)
        for arrival in recording.topic(topic.name).arrivals
        if isinstance(arrival.value, dict)
    ]


def part_of(recording: Recording, topic: Topic, keep: Callable[[Any], bool]) -> Recording:
    """The recording with only those messages of `topic` whose data `keep` accepts, watched from the first of them on.

    For a topic on which several talk, of whom one may be connected later than another.
    """
    seen = recording.topic(topic.name)
    kept = tuple(
        arrival
        for arrival in seen.arrivals
        if isinstance(arrival.value, dict) and keep(arrival.value.get("data"))
    )
    end = recording.simulated_s if seen.window is None else seen.window[1]
    window = (kept[0].t, end) if kept else seen.window
    part = replace(seen, arrivals=kept, window=window)
    return replace(recording, topics={**recording.topics, topic.name: part})


def elements(value: Any) -> list[Any]:
    """The elements of an array, or the value itself as the only one. Of a very long array, the first ones."""
    if isinstance(value, dict) and "first" in value:
        return list(value["first"])
    return value if isinstance(value, list) else [value]


def length_of(value: Any) -> int:
    """How many elements an array has, also one that was too long to be kept."""
    if isinstance(value, dict) and "length" in value:
        return int(value["length"])
    return len(elements(value))


@dataclass(frozen=True)
class Offender:
    """The first value that breaks a rule: message number, place in the array (None for a scalar), messages affected."""

    message: int
    place: int | None
    value: Any
    affected: int

    def __str__(self) -> str:
        where = f"message {self.message}" + ("" if self.place is None else f", element {self.place}")
        return f"{where} ({count(self.affected, 'message')} affected)"


def first_offender(recording: Recording, topic: Topic, breaks: Callable[[Any], bool]) -> Offender | None:
    """The first value or element that breaks a rule; None if all keep it."""
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
