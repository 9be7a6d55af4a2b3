"""How messages and ticks came to their callbacks: what waited, what was thrown away, what the threads did meanwhile.

All times are in s since the recording began. What was taken, called and waited for was noted while it happened, and so
was when each message arrived. What a full queue threw away follows from both: its oldest message, each time.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

Kind = Literal["subscription", "timer", "client", "service"]
NS = 1e9
SPINS_ON_S = 0.02
"""A thread that is back in the wait set, or in a callback, within this time never left `spin`."""
SAME_TICK_S = 0.5
"""Of a period: planned moments of a timer that are closer to each other are the same one."""


@dataclass(frozen=True)
class Source:
    """What an executor waits for: its kind, name, the name of its callback, and how much of it may wait.

    `period` (s) is that of a timer. `group` tells callback groups apart.
    """

    kind: Kind
    name: str
    callback: str
    depth: int
    period: float | None
    group: int


@dataclass(frozen=True)
class Item:
    """A message, a request, a response, or a tick of a timer, from when it was there (s) to when it was no more.

    `taken`: by the executor. `lost`: thrown away by a full queue, or a tick that found the one before it waiting.
    """

    source: int
    number: int
    came: float
    taken: float | None = None
    lost: float | None = None

    def waits(self, now: float) -> bool:
        """Whether it is in its queue at this moment."""
        gone = min(one for one in (self.taken, self.lost, float("inf")) if one is not None)
        return self.came <= now < gone


@dataclass(frozen=True)
class Call:
    """One run of a callback: which item it got, in which thread, from when to when (s), and when it was paused."""

    source: int
    number: int
    thread: int
    begin: float
    end: float
    pauses: Sequence[tuple[float, float]] = ()

    def runs(self, now: float) -> bool:
        """Whether it has begun and has not ended."""
        return self.begin <= now < self.end

    def is_paused(self, now: float) -> bool:
        """Whether it awaits something, and has given its thread back."""
        return any(begin <= now < end for begin, end in self.pauses)


@dataclass(frozen=True)
class Wait:
    """One wait of an executor in its wait set: from when to when (s), and for which sources."""

    begin: float
    end: float
    sources: Sequence[int]


@dataclass(frozen=True)
class MachineRecording:
    """What was noted of some nodes and their executor for `seconds`. `threads`: that run callbacks."""

    sources: Sequence[Source]
    items: Sequence[Item]
    calls: Sequence[Call]
    waits: Sequence[Wait]
    spinning: Sequence[tuple[float, float]]
    threads: int
    seconds: float

    def waiting(self, source: int, now: float) -> list[Item]:
        """What is in a queue at this moment, the oldest first."""
        return [one for one in self.items if one.source == source and one.waits(now)]

    def lost(self, source: int, now: float) -> list[Item]:
        """What a source has lost up to this moment."""
        return [
            one for one in self.items if one.source == source and one.lost is not None and one.lost <= now
        ]

    def running(self, now: float) -> list[Call]:
        """Callbacks that have begun and not ended at this moment."""
        return [call for call in self.calls if call.runs(now)]

    def looks(self, now: float) -> bool:
        """Whether a thread is in the wait set, or could be: the only one is not while it runs a callback."""
        busy = [call for call in self.running(now) if not call.is_paused(now)]
        return self.spins(now) and (self.threads > 1 or not busy)

    def spins(self, now: float) -> bool:
        """Whether a thread is inside `spin` at this moment."""
        return any(begin <= now <= end for begin, end in self.spinning)

    def waits_for(self, now: float) -> Sequence[int] | None:
        """Sources in the wait set at this moment, or in the last one; None before the first."""
        before = [wait for wait in self.waits if wait.begin <= now]
        return before[-1].sources if before else None


def from_notes(notes: Mapping[str, Any]) -> MachineRecording:
    """The recording from what `workbook/inside/machine_tap.py` has noted."""
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
    """Messages in the order in which they came."""
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
    """The items, with what a queue of this depth lost: its oldest one, for each new one too many."""
    queue: list[int] = []
    found = list(items)
    for place, item in enumerate(items):
        queue = [one for one in queue if not (taken := found[one].taken) or taken > item.came]
        if len(queue) >= depth:
            lost = next((one for one in queue if found[one].taken is None), None)
            if lost is not None:  # otherwise one of them was taken at this very moment
                queue.remove(lost)
                found[lost] = replace(found[lost], lost=item.came)
        queue.append(place)
    return found


def _ticks(
    place: int, source: Mapping[str, Any], calls: Sequence[Mapping[str, Any]], began: int, seconds: float
) -> list[Item]:
    """Ticks of a timer: those that its callback ran for, the planned ones that it missed, and the one that waits."""
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
    """Spans of time (s) without the gaps that are too short to count."""
    found: list[tuple[float, float]] = []
    for begin, end in sorted(spans):
        if found and begin - found[-1][1] <= SPINS_ON_S:
            found[-1] = (found[-1][0], max(found[-1][1], end))
        else:
            found.append((begin, end))
    return found
