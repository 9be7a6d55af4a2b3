"""Make recordings by hand, for criteria that need no robot."""

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

from workbook.recording.recording import (
    Arrival,
    Clock,
    NodeSeen,
    ProcessRecord,
    PublisherSeen,
    Recording,
    TopicRecording,
)

NODE = "/humanoid"
LIVING = ProcessRecord(program="answer.py", exit=0, ended_at=8.0, ended_by="judge", watched_for=8.0)


def publisher(kind: str, node: str = NODE) -> PublisherSeen:
    return PublisherSeen(node, kind, "reliable", "volatile", 0.0)


def on_topic(
    name: str,
    kind: str = "std_msgs/msg/Float32",
    times: Iterable[float] = (),
    values: Sequence[Any] | None = None,
    *,
    window: tuple[float, float] = (0.0, 14.0),
    node: str = NODE,
    undecodable: int = 0,
    not_kept: int = 0,
) -> TopicRecording:
    """Make a topic with messages at `times`. `values` are those of the field `data` (default: all 0.0)."""
    moments = list(times)
    contents = [0.0] * len(moments) if values is None else list(values)
    arrivals = tuple(Arrival(t, t, {"data": value}) for t, value in zip(moments, contents, strict=True))
    return TopicRecording(name, (publisher(kind, node),), (), arrivals, window, undecodable, not_kept)


def recorded(
    *topics: TopicRecording, process: ProcessRecord = LIVING, clock: Clock = "wall", nodes: bool = True
) -> Recording:
    """Make a recording of 14 s of these topics."""
    return Recording(
        clock=clock,
        domain_id=17,
        watched_s=14.0,
        wall_s=14.5,
        topics={topic.name: topic for topic in topics},
        nodes=(NodeSeen(NODE, 0.1),) if nodes else (),
        process=process,
        follows_clock=True if clock == "simulated" else None,
        step_s=0.1 if clock == "simulated" else None,
    )


def ended_by_itself(log: str = "", exit: int = 1, signal: str | None = None) -> ProcessRecord:
    return replace(
        LIVING, exit=None if signal else exit, signal=signal, ended_at=2.5, ended_by="itself", log=log
    )


def every(period: float, count: int, start: float | None = None) -> list[float]:
    """Return `count` times, one every `period` seconds."""
    first = period if start is None else start
    return [first + period * index for index in range(count)]
