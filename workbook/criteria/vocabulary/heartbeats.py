"""Measure a heartbeat, to judge whether it continues even while the program is busy with other work."""

from bisect import bisect_left, bisect_right
from collections.abc import Sequence
from dataclasses import dataclass

from workbook.criteria.criterion import Topic
from workbook.criteria.vocabulary.estimators import Gap
from workbook.criteria.vocabulary.rates import topic_pace
from workbook.criteria.vocabulary.topics import window_of
from workbook.recording.recording import Recording


@dataclass(frozen=True)
class Beats:
    """The heartbeats that arrived, the number that were due, and the longest silence.

    `times`: arrival times (simulated time, s). `hz`: the expected rate. `typical_s`: the typical interval (s) between
    two heartbeats, or 0 if there are fewer than two. `burst`: the number of heartbeats that typically arrive together.
    """

    times: tuple[float, ...]
    hz: float
    due: int
    typical_s: float
    silence: Gap
    burst: int

    @property
    def count(self) -> int:
        """The number of heartbeats that arrived."""
        return len(self.times)

    @property
    def last_s(self) -> float:
        """The time of the last heartbeat (s), or 0 if there is none."""
        return self.times[-1] if self.times else 0.0

    @property
    def share(self) -> float:
        """The number of heartbeats that arrived, divided by the number due. It's above 1 if too many arrived."""
        return self.count / max(1, self.due)

    def within(self, spans: Sequence[tuple[float, float]]) -> list[int]:
        """Count the heartbeats in each span of time, such as the spans in which the program is busy.

        A span is a pair of its start and end (s).
        """
        times = sorted(self.times)
        return [max(0, bisect_right(times, end) - bisect_left(times, begin)) for begin, end in spans]

    def due_within(self, spans: Sequence[tuple[float, float]]) -> float:
        """Return the total number of heartbeats that are due in these spans."""
        return sum(end - begin for begin, end in spans) * self.hz


def beats(recording: Recording, topic: Topic) -> Beats:
    """Return the heartbeats on `topic` in its window: their times, the number due, and the longest silence."""
    seen, arrived = topic_pace(recording, topic), recording.topic(topic.name)
    start, end = window_of(recording, arrived)
    times, hz = tuple(arrival.t for arrival in arrived.arrivals), topic.hz or 0.0
    return Beats(times, hz, round((end - start) * hz), seen.typical_interval or 0.0, seen.gap, seen.burst)
