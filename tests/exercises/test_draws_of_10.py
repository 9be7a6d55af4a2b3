"""Exercise 10: for every draw, each kind of mistake gets its own cause. No program runs here."""

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

import pytest

from tests.criteria.by_hand import on_topic, recorded
from tests.exercises.proofs import ROOT
from workbook.exercise.definition import load_exercise
from workbook.recording.recording import Published
from workbook.recording.script import Publishes

EXERCISE = load_exercise("10_slow_callbacks", ROOT)
CRITERIA = {one.id: one for one in EXERCISE.criteria}
JUDGED = EXERCISE.criteria[-1].judge.__globals__
LINK_M, PLANNING_S = JUDGED["LINK_M"], JUDGED["PLANNING_S"]
planned: Callable[[float], float] = JUDGED["planned"]
formula: Callable[[float], float] = JUDGED["bend_for"]
SEEDS = 60
Event = tuple[float, float]
"""When (s) a distance (m) was requested; or when a plan was published, and its bend (rad)."""
Waiting = list[float]


def requested(seed: int) -> list[Event]:
    [part] = EXERCISE.drawn(seed).plan.script.parts
    assert isinstance(part, Publishes)
    return [(line.at, line.value["data"]) for line in part.lines]


def served(
    requests: Sequence[Event],
    bend: Callable[[float], float] = planned,
    *,
    take: Callable[[Waiting], int] = lambda waiting: 0,
    accept: Callable[[Waiting, bool, float], bool] = lambda waiting, busy, distance: True,
    takes_s: float = PLANNING_S + 0.005,
) -> list[Event]:
    """Return one worker's plans. It `take`s one of the waiting distances (m), if they were `accept`ed before."""
    plans: list[Event] = []
    waiting: Waiting = []
    free_at = 0.0
    for at, distance in [*requests, (math.inf, 0.0)]:
        while waiting and free_at <= at:
            free_at += takes_s
            plans.append((free_at, bend(waiting.pop(take(waiting)))))
        if accept(waiting, free_at > at, distance):
            if free_at <= at:
                free_at = at + takes_s
                plans.append((free_at, bend(distance)))
            else:
                waiting.append(distance)
    return [(at, one) for at, one in plans if at < EXERCISE.plan.wall_s]


def causes_over_all_draws(wrong: Callable[[list[Event]], Sequence[Event]], criterion: str) -> set[str]:
    """Return the causes that this criterion names, over all draws; "" if it passes."""
    causes = set()
    for seed in range(SEEDS):
        requests = requested(seed)
        said = tuple(
            Published("/robot/plan_request", at, at, {"data": distance}) for at, distance in requests
        )
        plans = sorted(wrong(requests))
        heard = on_topic("/robot/plan", times=[at for at, _ in plans], values=[bend for _, bend in plans])
        causes.add(CRITERIA[criterion](replace(recorded(heard), published=said)).cause)
    return causes


def sent_as(measure: Callable[[float], float]) -> Callable[[list[Event]], Sequence[Event]]:
    """Plan for each request, but publish a number for another distance (m)."""
    return lambda requests: served(requests, measure)


def later(plans: Sequence[Event]) -> list[Event]:
    """Publish each plan one request too late."""
    return [(at, bend) for (at, _), bend in zip(plans, [0.0, *(bend for _, bend in plans)], strict=False)]


def from_memory(requests: list[Event]) -> list[Event]:
    known: set[float] = set()
    plans, free_at = [], 0.0
    for at, distance in requests:
        free_at = max(free_at, at) + (0.0 if distance in known else PLANNING_S)
        known.add(distance)
        plans.append((free_at, planned(distance)))
    return plans


def known_from_the_notebook(requests: list[Event]) -> list[Event]:
    plans, free_at = [], 0.0
    for at, distance in requests:
        free_at = max(free_at, at) + (0.0 if distance == 0.7 else PLANNING_S)
        plans.append((free_at, 1.0107 if distance == 0.7 else planned(distance)))
    return plans


PLANS_RIGHT: dict[str, Callable[[list[Event]], Sequence[Event]]] = {
    "": served,
    "degrees": sent_as(lambda distance: math.degrees(planned(distance))),
    "half": sent_as(lambda distance: planned(distance) / 2.0),
    "distance": sent_as(lambda distance: distance),
    "distance-rounded": sent_as(lambda distance: planned(round(distance, 2))),
    "formula": sent_as(formula),
    "inexact": sent_as(lambda distance: round(planned(distance), 2)),
    "straight-by-hand": sent_as(lambda distance: 0.0 if distance > 2.0 * LINK_M else planned(distance)),
    "not-finite": sent_as(lambda distance: math.nan if distance > 2.0 * LINK_M else planned(distance)),
    "one-behind": lambda requests: later(served(requests)),
    "besides": lambda requests: [(1.9, 0.0), *served(requests)],
    "from-memory": from_memory,
    "planner-left-out": known_from_the_notebook,
}


@pytest.mark.parametrize("cause", PLANS_RIGHT)
def test_a_wrong_plan_is_told_in_each_draw(cause: str) -> None:
    assert causes_over_all_draws(PLANS_RIGHT[cause], "plans_right") == {cause and f"plans-right.{cause}"}


@pytest.mark.parametrize(
    "measure",
    [lambda distance: planned(distance / 100.0), lambda distance: planned(max(distance, 0.15))],
    ids=["centimeters", "never-so-near"],
)
def test_a_plan_for_another_distance_is_told_in_each_draw(measure: Callable[[float], float]) -> None:
    assert causes_over_all_draws(sent_as(measure), "plans_right") == {"plans-right.fits-no-request"}
    assert causes_over_all_draws(sent_as(measure), "all_in_order") == {""}


@pytest.mark.parametrize("cause", ["degrees", "half", "distance"])
def test_another_measure_keeps_the_order_in_each_draw(cause: str) -> None:
    assert causes_over_all_draws(PLANS_RIGHT[cause], "all_in_order") == {""}


def unless_before(requests: list[Event]) -> list[Event]:
    before = [0.0, *(distance for _, distance in requests)]
    return served([one for one, last in zip(requests, before, strict=False) if one[1] != last])


def newest_alone(requests: list[Event]) -> list[Event]:
    """Let only the newest request wait."""

    def accept(waiting: Waiting, busy: bool, distance: float) -> bool:
        waiting.clear()
        return True

    return served(requests, accept=accept)


ALL_IN_ORDER: dict[str, list[Callable[[list[Event]], Sequence[Event]]]] = {
    "": [served],
    "first-missing": [lambda requests: served(requests)[1:]],
    "out-of-reach": [lambda requests: served([one for one in requests if one[1] < 2.0 * LINK_M])],
    "asked-before": [unless_before],
    "last-missing": [lambda requests: served(requests, accept=lambda waiting, _, one: one not in waiting)],
    "missing": [lambda requests: served(requests, accept=lambda _, busy, one: not busy), newest_alone],
    "stops-or-refuses": [lambda requests: served(requests)[:5]],
    "too-slow": [lambda requests: served(requests, takes_s=2 * PLANNING_S)],
    "with-the-next": [lambda requests: later(served(requests))[1:]],
    "twice": [lambda requests: sorted([*served(requests), *served(requests)])],
    "other-order": [
        lambda requests: served(requests, take=lambda waiting: waiting.index(min(waiting))),
        lambda requests: served(requests, take=lambda waiting: waiting.index(max(waiting))),
        lambda requests: served(requests, take=lambda waiting: len(waiting) - 1),
    ],
    "side-by-side": [lambda requests: [(at + PLANNING_S, planned(distance)) for at, distance in requests]],
}


@pytest.mark.parametrize("cause", ALL_IN_ORDER)
def test_what_becomes_of_the_requests_is_told_in_each_draw(cause: str) -> None:
    for wrong in ALL_IN_ORDER[cause]:
        assert causes_over_all_draws(wrong, "all_in_order") == {cause and f"all-in-order.{cause}"}


def test_the_plans_of_one_run_are_wrong_in_each_other() -> None:
    table = served(requested(SEEDS))
    assert "" not in causes_over_all_draws(lambda requests: table, "plans_right")


def test_an_idle_planner_gets_the_fourth_request_and_the_last_plan_is_there_in_time() -> None:
    for seed in range(SEEDS):
        requests = requested(seed)
        plans = served(requests)
        assert len(requests) == len(plans) == 7
        assert plans[2][0] + 0.2 < requests[3][0]
        assert requests[6][0] - requests[3][0] < 0.5 and requests[6][0] <= 4.0
        assert plans[6][0] < EXERCISE.plan.wall_s - 1.5
