"""Store how messages and timer ticks reached their callbacks, which of them were lost, and what the threads did.

The "machine" is the machinery between a message and its callback: queues, wait set, executor, and threads. All times
are in seconds since the recording began. `machine_tap` recorded arrivals, takes, calls, and waits as they happened.
Dropped messages are computed from those, because a full queue drops its oldest message for each new one.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

Kind = Literal["subscription", "timer", "client", "service"]
NS = 1e9
SPINS_ON_S = 0.02
"""If a thread is back in the wait set or in a callback within this time (s), we assume that it never left `spin`."""
SAME_TICK_S = 0.5
"""Planned timer ticks that are closer together than this fraction of the timer's period count as the same tick."""


@dataclass(frozen=True)
class Source:
    """A source of work that an executor waits for: its kind, name, callback name, and queue depth.

    `period` (s) is None unless the source is a timer. `group` identifies the callback group.
    """

    kind: Kind
    name: str
    callback: str
    depth: int
    period: float | None
    group: int


@dataclass(frozen=True)
class Item:
    """A message, request, response, or timer tick, which waits in its source's queue until an executor takes it.

    `source`: the source's index. `number`: the item's number within its source, starting at 1. `came`: the time (s) at
    which it arrived. `taken`: the time (s) at which the executor took it, or None if that didn't happen. `lost`: the
    time (s) at which a full queue dropped it or a timer missed the tick, or None if it wasn't lost.
    """

    source: int
    number: int
    came: float
    taken: float | None = None
    lost: float | None = None

    def waits(self, now: float) -> bool:
        """Return whether the item is in its queue at time `now`."""
        gone = min(one for one in (self.taken, self.lost, float("inf")) if one is not None)
        return self.came <= now < gone


@dataclass(frozen=True)
class Call:
    """One run of a callback: the item that it handles, its thread, its start and end times (s), and its pauses."""

    source: int
    number: int
    thread: int
    begin: float
    end: float
    pauses: Sequence[tuple[float, float]] = ()

    def runs(self, now: float) -> bool:
        """Return whether the call is in progress at time `now`."""
        return self.begin <= now < self.end

    def is_paused(self, now: float) -> bool:
        """Return whether the call is at an `await` at time `now` and has released its thread."""
        return any(begin <= now < end for begin, end in self.pauses)


@dataclass(frozen=True)
class Wait:
    """One wait of an executor for its wait set: the start and end times (s), and the indexes of the set's sources."""

    begin: float
    end: float
    sources: Sequence[int]


@dataclass(frozen=True)
class MachineRecording:
    """A recording of one or more nodes and their executor. `seconds`: its duration.

    `spinning`: the start and end times (s) of the intervals in which a thread was inside `spin`. `threads`: the number
    of threads that run callbacks.
    """

    sources: Sequence[Source]
    items: Sequence[Item]
    calls: Sequence[Call]
    waits: Sequence[Wait]
    spinning: Sequence[tuple[float, float]]
    threads: int
    seconds: float

    def waiting(self, source: int, now: float) -> list[Item]:
        """Return the items in a source's queue at time `now`, oldest first."""
        return [one for one in self.items if one.source == source and one.waits(now)]

    def lost(self, source: int, now: float) -> list[Item]:
        """Return the items that a source has lost by time `now`."""
        return [
            one for one in self.items if one.source == source and one.lost is not None and one.lost <= now
        ]

    def running(self, now: float) -> list[Call]:
        """Return the calls that are in progress at time `now`."""
        return [call for call in self.calls if call.runs(now)]

    def looks(self, now: float) -> bool:
        """Return whether a thread is waiting in the wait set at time `now`, or could be.

        If the executor has only one thread, that thread can't wait while it runs a callback.
        """
        busy = [call for call in self.running(now) if not call.is_paused(now)]
        return self.spins(now) and (self.threads > 1 or not busy)

    def spins(self, now: float) -> bool:
        """Return whether a thread is inside `spin` at time `now`."""
        return any(begin <= now <= end for begin, end in self.spinning)

    def waits_for(self, now: float) -> Sequence[int] | None:
        """Return the indexes of the sources in the current or latest wait, or None before the first wait."""
        before = [wait for wait in self.waits if wait.begin <= now]
        return before[-1].sources if before else None


def from_notes(notes: Mapping[str, Any]) -> MachineRecording:
    """Build a recording from the notes that `workbook/inside/machine_tap.py` takes."""
    began: int = notes["began"]
    seconds = (notes["ended"] - began) / NS

    def since(moment: int | None) -> float | None:
        return None if moment is None else (moment - began) / NS

    def until(moment: int | None) -> float:
        return seconds if moment is None else (moment - began) / NS

    items, calls = [], []
    for place, source in enumerate(notes["sources"]):
        own = [call for call in notes["calls"] if call["source"] == place]
        if source["kind"] == "timer":
            found = _ticks(place, source, own, began, seconds)
        else:
            arrivals = [one for one in notes["arrivals"] if one["source"] == place]
            found = _messages(place, source, own, arrivals, began)
        items += found
        number_of = {one.taken: one.number for one in found}
        for call in own:
            pauses = [(until(begin), until(end)) for begin, end in call["pauses"]]
            begin = until(call["begin"] or call["taken"])
            number = number_of.get(since(call["taken"]), 0)
            calls.append(Call(place, number, call["thread"], begin, until(call["end"]), pauses))
    waits = [Wait(until(one["begin"]), until(one["end"]), tuple(one["in"])) for one in notes["waits"]]
    return MachineRecording(
        [_source(one, notes) for one in notes["sources"]],
        sorted(items, key=lambda one: (one.came, one.source)),
        sorted(calls, key=lambda one: one.begin),
        sorted(waits, key=lambda one: one.begin),
        _joined([*((one.begin, one.end) for one in waits), *((one.begin, one.end) for one in calls)]),
        notes["executor"]["threads"],
        seconds,
    )


def _source(source: Mapping[str, Any], notes: Mapping[str, Any]) -> Source:
    groups = list(dict.fromkeys(one["group"] for one in notes["sources"]))
    period = None if source["period"] is None else source["period"] / NS
    name = source["name"] if period is None else f"timer, {period:g} s"
    group = groups.index(source["group"])
    return Source(source["kind"], name, source["callback"], source["depth"], period, group)


def _messages(
    place: int,
    source: Mapping[str, Any],
    calls: Sequence[Mapping[str, Any]],
    arrivals: Sequence[Mapping[str, Any]],
    began: int,
) -> list[Item]:
    """Return a source's messages in order of arrival, with the dropped ones marked."""
    taken = {call["sent"]: call for call in calls if call["sent"] is not None}
    came = {one["sent"]: one["arrived"] for one in arrivals}
    came |= {sent: call["arrived"] for sent, call in taken.items()}
    order = sorted(came.items(), key=lambda one: one[1])
    items = []
    for number, (sent, arrived) in enumerate(order, start=1):
        when = (taken[sent]["taken"] - began) / NS if sent in taken else None
        items.append(Item(place, number, (arrived - began) / NS, when))
    return _thrown_away(items, source["depth"])


def _thrown_away(items: Sequence[Item], depth: int) -> list[Item]:
    """Mark the dropped items. A queue of this depth drops its oldest item for each new item that doesn't fit."""
    queue: list[int] = []
    found = list(items)
    for place, item in enumerate(items):
        queue = [one for one in queue if not (taken := found[one].taken) or taken > item.came]
        if len(queue) >= depth:
            lost = next((one for one in queue if found[one].taken is None), None)
            if lost is not None:  # otherwise, the executor took an item at the same time
                queue.remove(lost)
                found[lost] = replace(found[lost], lost=item.came)
        queue.append(place)
    return found


def _ticks(
    place: int, source: Mapping[str, Any], calls: Sequence[Mapping[str, Any]], began: int, seconds: float
) -> list[Item]:
    """Return a timer's ticks: those that ran its callback, planned ticks that were missed, and a tick still waiting."""
    period = source["period"] / NS
    items: list[Item] = []

    def add(came: float, taken: float | None, following: float) -> None:
        items.append(Item(place, len(items) + 1, came, taken))
        missed = came + period
        while missed < min(following - SAME_TICK_S * period, seconds):
            if missed > 0:
                items.append(Item(place, len(items) + 1, missed, None, missed))
            missed += period

    for call in calls:
        due, following, taken = ((call[name] or call["taken"]) for name in ("due", "next_due", "taken"))
        add((due - began) / NS, (taken - began) / NS, (following - began) / NS)
    if source["next_due"] is not None and (last := (source["next_due"] - began) / NS) < seconds:
        add(last, None, seconds + period)
    return items


def _joined(spans: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    """Join time spans (s) that are at most `SPINS_ON_S` apart."""
    found: list[tuple[float, float]] = []
    for begin, end in sorted(spans):
        if found and begin - found[-1][1] <= SPINS_ON_S:
            found[-1] = (found[-1][0], max(found[-1][1], end))
        else:
            found.append((begin, end))
    return found
