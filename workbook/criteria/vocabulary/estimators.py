"""Estimate rates, gaps, and bursts from arrival times. These pure functions tolerate jitter and a lost message."""

import statistics
from collections.abc import Sequence
from dataclasses import dataclass

PAIR_FRACTION = 0.2


@dataclass(frozen=True)
class Gap:
    """The longest silence, from `start` to `end` (s).

    `kind`: "before" the first message, "between" two messages, "after" the last message, or "nothing" if no message
    arrived.
    """

    start: float
    end: float
    kind: str

    @property
    def seconds(self) -> float:
        """The length of the silence (s)."""
        return self.end - self.start


@dataclass(frozen=True)
class Pace:
    """The distribution of arrivals over a window: their number, mean rate, median interval, longest gap, and bursts.

    `hz` and `typical_interval` (s) are None if there are fewer than two arrivals.
    """

    count: int
    hz: float | None
    typical_interval: float | None
    gap: Gap
    burst: int

    @property
    def in_bursts(self) -> bool:
        """Whether messages arrive two or more at a time instead of evenly."""
        return self.burst > 1


def mean_rate(times: Sequence[float]) -> float | None:
    """Return the mean rate (Hz) between the first and last arrivals, or None if there aren't two different times."""
    if len(times) < 2 or times[-1] <= times[0]:
        return None
    return (len(times) - 1) / (times[-1] - times[0])


def longest_gap(times: Sequence[float], start: float, end: float) -> Gap:
    """Return the longest silence within [start, end] (s), including the silences before and after all arrivals."""
    if not times:
        return Gap(start, end, "nothing")
    gaps = [Gap(start, times[0], "before")]
    gaps += [Gap(a, b, "between") for a, b in zip(times, times[1:], strict=False)]
    gaps.append(Gap(times[-1], end, "after"))
    return max(gaps, key=lambda gap: gap.seconds)


def group_starts(times: Sequence[float], near: float) -> list[float]:
    """Return the start of each group of arrivals that are at most `near` seconds apart."""
    starts: list[float] = []
    last = None
    for time in times:
        if last is None or time - last > near:
            starts.append(time)
        last = time
    return starts


def burst_size(times: Sequence[float], period: float) -> int:
    """Return the number of messages that typically arrive together: 1 for an even stream, 2 for pairs.

    Arrivals at most a fifth of `period` (s) apart belong together. If all messages are that close, the stream counts as
    even, not as one endless burst.
    """
    if len(times) < 4:
        return 1
    starts = group_starts(times, PAIR_FRACTION * period)
    if len(starts) < 2:
        return 1
    size = round(len(times) / len(starts))
    intervals = [b - a for a, b in zip(starts, starts[1:], strict=False)]
    spread_out = statistics.median(intervals) > 3 * PAIR_FRACTION * period
    return size if size > 1 and spread_out else 1


def pace(times: Sequence[float], start: float, end: float, period: float) -> Pace:
    """Describe the pace of arrivals (s, ascending) in the window [start, end], given the expected `period` (s)."""
    intervals = [b - a for a, b in zip(times, times[1:], strict=False)]
    return Pace(
        count=len(times),
        hz=mean_rate(times),
        typical_interval=statistics.median(intervals) if intervals else None,
        gap=longest_gap(times, start, end),
        burst=burst_size(times, period),
    )
