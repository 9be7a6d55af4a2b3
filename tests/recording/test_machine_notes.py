"""Evaluate a machine's notes: waiting messages, dropped messages, and missed ticks."""

from typing import Any

import pytest

from workbook.recording.machine import MachineRecording, from_notes

SECOND = 10**9


def source(
    kind: str, depth: int = 10, period: float | None = None, next_due: float | None = None
) -> dict[str, Any]:
    return {
        "kind": kind,
        "name": "/robot/distance",
        "callback": "on_it",
        "depth": depth,
        "period": None if period is None else int(period * SECOND),
        "group": 7,
        "node": "guard",
        "next_due": None if next_due is None else int(next_due * SECOND),
    }


def call(taken: float, end: float | None, **more: Any) -> dict[str, Any]:
    moments = {
        name: int(value * SECOND)
        for name, value in more.items()
        if name in ("sent", "arrived", "due", "next_due")
    }
    begun = {"taken": int(taken * SECOND), "begin": int(taken * SECOND), "end": end and int(end * SECOND)}
    none = {"sent": None, "arrived": None, "due": None, "next_due": None}
    return {"source": 0, "thread": 1, "pauses": more.get("pauses", []), **none, **begun, **moments}


def recorded(one: dict[str, Any], calls: list[Any], arrivals: list[float] | None = None) -> MachineRecording:
    return from_notes(
        {
            "began": 0,
            "ended": 10 * SECOND,
            "executor": {"name": "SingleThreadedExecutor", "threads": 1},
            "sources": [one],
            "arrivals": [
                {"source": 0, "sent": int(t * SECOND), "arrived": int(t * SECOND)} for t in arrivals or ()
            ],
            "calls": calls,
            "waits": [{"thread": 1, "in": [0], "begin": 2 * SECOND, "end": 3 * SECOND}],
        }
    )


def test_a_full_queue_loses_its_oldest_message() -> None:
    seen = recorded(source("subscription", depth=2), [], [1.0, 2.0, 3.0, 4.0])
    assert [one.number for one in seen.waiting(0, 2.5)] == [1, 2]
    assert [one.number for one in seen.waiting(0, 5.0)] == [3, 4]
    assert [(one.number, one.lost) for one in seen.lost(0, 5.0)] == [(1, 3.0), (2, 4.0)]


def test_a_message_that_was_taken_makes_room() -> None:
    seen = recorded(source("subscription", depth=2), [call(2.5, 2.6, sent=1.0, arrived=1.0)], [1.0, 2.0, 3.0])
    assert seen.lost(0, 9.0) == []
    assert [one.number for one in seen.waiting(0, 9.0)] == [2, 3]
    [ran] = seen.calls
    assert (ran.number, ran.begin, ran.end) == (1, 2.5, 2.6)


def test_a_late_tick_is_one_tick_and_the_planned_ones_in_between_are_missed() -> None:
    seen = recorded(source("timer", period=1.0, next_due=12.0), [call(4.5, 4.6, due=1.0, next_due=5.0)])
    assert [one.came for one in seen.lost(0, 9.0)] == [2.0, 3.0, 4.0]
    assert [one.came for one in seen.waiting(0, 3.5)] == [1.0]
    assert seen.waiting(0, 4.55) == []


def test_a_tick_that_nobody_serves_waits_until_the_end() -> None:
    seen = recorded(source("timer", period=2.0, next_due=5.0), [])
    assert [one.came for one in seen.waiting(0, 9.5)] == [5.0]
    assert [one.came for one in seen.lost(0, 9.5)] == [7.0, 9.0]


def test_the_only_thread_does_not_look_while_a_callback_runs() -> None:
    seen = recorded(source("subscription"), [call(3.0, 4.0, sent=1.0, arrived=1.0)])
    assert [seen.looks(now) for now in (1.0, 2.5, 3.5)] == [False, True, False]


def test_a_callback_that_awaits_gives_its_thread_back() -> None:
    paused = [[int(3.2 * SECOND), int(3.8 * SECOND)]]
    seen = recorded(source("subscription"), [call(3.0, 4.0, sent=1.0, arrived=1.0, pauses=paused)])
    assert [seen.looks(now) for now in (3.1, 3.5, 3.9)] == [False, True, False]


def test_an_await_that_never_ends_keeps_no_thread() -> None:
    paused = [[int(3.2 * SECOND), None]]
    seen = recorded(source("subscription"), [call(3.0, None, sent=1.0, arrived=1.0, pauses=paused)])
    assert [seen.looks(now) for now in (3.1, 9.5)] == [False, True]


@pytest.mark.parametrize(("now", "spins"), [(1.0, False), (2.5, True), (3.5, False)])
def test_it_says_when_somebody_spins(now: float, spins: bool) -> None:
    assert recorded(source("subscription"), []).spins(now) is spins
