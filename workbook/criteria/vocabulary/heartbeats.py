"""Judges a heartbeat: whether it continues, also while the program is busy with something else."""

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
    """The beats that came, how many were due, and the longest silence.

    `typical_s`: the typical interval (s) between two; 0 with fewer than two.
    """

    count: int
    due: int
    typical_s: float
    silence: Gap

    @property
    def share(self) -> float:
        """Beats that came, divided by the beats that were due; more than 1 when there were too many."""
        return self.count / max(1, self.due)


def beats(recording: Recording, topic: Topic) -> Beats:
    """The beats of `topic` in its window: how many came, how many were due, and the longest silence."""
    seen = topic_pace(recording, topic)
    start, end = window_of(recording, recording.topic(topic.name))
    return Beats(seen.count, round((end - start) * (topic.hz or 0.0)), seen.typical_interval or 0.0, seen.gap)


@dataclass(frozen=True)
class BeatsMeanwhile:
    """The beats that came in some spans, and how many were due. `silent_from` (s): begins of spans without any."""

    came: int
    due: float
    silent_from: tuple[float, ...]


def beats_meanwhile(
    recording: Recording, topic: Topic, spans: Sequence[tuple[float, float]]
) -> BeatsMeanwhile:
    """How many beats came and were due while the program was busy. `spans`: start and end (s of simulated time)."""
    times = sorted(arrival.t for arrival in recording.topic(topic.name).arrivals)
    came = [max(0, bisect_right(times, end) - bisect_left(times, begin)) for begin, end in spans]
    return BeatsMeanwhile(
        came=sum(came),
        due=sum(end - begin for begin, end in spans) * (topic.hz or 0.0),
        silent_from=tuple(begin for (begin, _), beats in zip(spans, came, strict=True) if not beats),
    )
