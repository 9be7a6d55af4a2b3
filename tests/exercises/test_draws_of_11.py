"""Exercise 11: for every draw, each kind of mistake gets its own cause. No program runs here."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import groupby

import pytest

from tests.criteria.by_hand import on_topic, recorded
from tests.exercises.proofs import ROOT
from workbook.criteria import Recording
from workbook.exercise.definition import load_exercise
from workbook.recording.recording import Published
from workbook.recording.script import Publishes

EXERCISE = load_exercise("11_polling_against_callbacks", ROOT)
CRITERIA = {one.id: one for one in EXERCISE.criteria}
SEEDS = 60
PROMPTLY_S = 0.002
Touch = tuple[float, int]
"""When (s) a touch came, and its number; or a report of it."""


def touches(seed: int) -> list[Touch]:
    [part] = EXERCISE.drawn(seed).plan.script.parts
    assert isinstance(part, Publishes)
    return [(line.at, line.value["data"]) for line in part.lines]


def recording_of(said: Sequence[Touch], reports: Sequence[Touch]) -> Recording:
    words = tuple(Published("/robot/touch", at, at, {"data": number}) for at, number in said)
    times, numbers = [at + PROMPTLY_S for at, _ in reports], [number for _, number in reports]
    return replace(recorded(on_topic("/monitor/seen", "std_msgs/msg/Int32", times, numbers)), published=words)


def causes_over_all_draws(wrong: Callable[[list[Touch]], Sequence[Touch]], criterion: str) -> set[str]:
    """Return the causes that this criterion names, over all draws; "" if it passes."""
    drawn = [touches(seed) for seed in range(SEEDS)]
    return {CRITERIA[criterion](recording_of(said, wrong(said))).cause for said in drawn}


def without(kept: Callable[[list[int], int], bool]) -> Callable[[list[Touch]], list[Touch]]:
    """Report only the touches for which `kept` is true, given the numbers before and the touch's number."""

    def reports(said: list[Touch]) -> list[Touch]:
        numbers = [number for _, number in said]
        return [one for place, one in enumerate(said) if kept(numbers[:place], one[1])]

    return reports


def filled(said: list[Touch]) -> list[Touch]:
    before = [number for _, number in said[:1]] + [number for _, number in said]
    return [
        (at, one)
        for (at, number), last in zip(said, before, strict=False)
        for one in [*range(last + 1, number), number]
    ]


def bunches(said: list[Touch]) -> Iterator[list[Touch]]:
    for _, some in groupby(said, lambda one: one[0]):
        yield [*some]


def newest_first(said: list[Touch]) -> list[Touch]:
    return [one for bunch in bunches(said) for one in reversed(bunch)]


def by_number(said: list[Touch]) -> list[Touch]:
    return [one for bunch in bunches(said) for one in sorted(bunch)]


def with_sums(said: list[Touch]) -> list[Touch]:
    """After touches in rapid succession, also report how many there were."""
    return [
        one
        for bunch in bunches(said)
        for one in [*bunch, *([(bunch[0][0] + 0.1, len(bunch))] if len(bunch) > 5 else [])]
    ]


def in_dozens(said: list[Touch]) -> list[Touch]:
    return [(said[place // 12 * 12 + 11][0], number) for place, (_, number) in enumerate(said)]


def with_the_next(said: list[Touch]) -> list[Touch]:
    return [(at, number) for (_, number), (at, _) in zip(said, said[1:], strict=False)]


def polled(said: list[Touch]) -> list[Touch]:
    """Five times a second, report the last touch if it has changed."""
    found: list[Touch] = []
    for look in range(1, 46):
        last = [number for at, number in said if at <= look / 5][-1:]
        if last and last != [number for _, number in found[-1:]]:
            found.append((look / 5, last[0]))
    return found


def at_once(said: list[Touch]) -> list[Touch]:
    return said


NONE_MISSED: dict[str, Callable[[list[Touch]], Sequence[Touch]]] = {
    "": at_once,
    "the-first": lambda said: said[1:],
    "the-last": with_the_next,
    "after-the-pause": lambda said: [*said[:49], *said[50:]],
    "stops": lambda said: said[:49],
    "smaller-numbers": without(lambda before, one: one > max(before, default=0)),
    "greater-numbers": without(lambda before, one: one <= 60),
    "at-the-restart": without(lambda before, one: one >= max(before[-1:], default=0)),
    "after-a-gap": without(lambda before, one: not 0 < max(before[-1:], default=0) + 1 < one or not before),
    "cut-off": lambda said: [(at, number % 256) for at, number in said],
    "came-together": polled,
}


@pytest.mark.parametrize("cause", NONE_MISSED)
def test_what_is_missed_is_told_in_each_draw(cause: str) -> None:
    assert causes_over_all_draws(NONE_MISSED[cause], "none_missed") == {cause and f"none-missed.{cause}"}


@pytest.mark.parametrize(
    "wrong",
    [without(lambda before, one: one not in before), without(lambda before, one: [one] != before[-1:])],
)
def test_a_number_that_came_before_is_told_in_each_draw(
    wrong: Callable[[list[Touch]], Sequence[Touch]],
) -> None:
    assert causes_over_all_draws(wrong, "none_missed") == {"none-missed.number-known"}


ONCE_IN_ORDER: dict[str, Callable[[list[Touch]], Sequence[Touch]]] = {
    "": at_once,
    "gap-filled": filled,
    "besides-all": with_sums,
    "other-order": newest_first,
    "sorted": by_number,
    "cut-off": lambda said: [(at, number % 256) for at, number in said],
    "twice": lambda said: [one for one in said for _ in range(2)],
    "no-touch": lambda said: [(at, number + 1) for at, number in said],
}


@pytest.mark.parametrize("cause", ONCE_IN_ORDER)
def test_what_is_reported_besides_is_told_in_each_draw(cause: str) -> None:
    assert causes_over_all_draws(ONCE_IN_ORDER[cause], "once_in_order") == {
        cause and f"once-in-order.{cause}"
    }


QUICK: dict[str, Callable[[list[Touch]], Sequence[Touch]]] = {
    "": at_once,
    "with-the-next": with_the_next,
    "collected": in_dozens,
    "held-back": lambda said: [(at + 0.03, number) for at, number in said],
}


@pytest.mark.parametrize("cause", QUICK)
def test_how_late_reports_are_is_told_in_each_draw(cause: str) -> None:
    assert causes_over_all_draws(QUICK[cause], "quick") == {cause and f"quick.{cause}"}


@pytest.mark.parametrize(("criterion", "cause"), [("none_missed", "no-touch"), ("once_in_order", "no-touch")])
def test_the_numbers_of_one_run_are_wrong_in_each_other(criterion: str, cause: str) -> None:
    table = [number for _, number in touches(SEEDS)]

    def from_a_table(said: list[Touch]) -> list[Touch]:
        return [(at, number) for (at, _), number in zip(said, table, strict=True)]

    assert causes_over_all_draws(from_a_table, criterion) == {f"{criterion.replace('_', '-')}.{cause}"}


def test_the_watch_ends_when_the_last_reports_have_come() -> None:
    ends = [touches(seed)[-1][0] for seed in range(SEEDS)]
    assert max(ends) < EXERCISE.plan.wall_s - 0.65
    assert max(ends) - min(ends) > 0.3
