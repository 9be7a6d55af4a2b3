"""The inputs of the drivers of 03, 06, and 07: every draw has the properties that criteria and causes rely on."""

from collections import Counter
from itertools import pairwise
from typing import Any

import pytest

from tests.exercises.proofs import ROOT, SEEDS
from workbook.exercise.definition import load_exercise
from workbook.recording.script import Publishes


def words(exercise: str, seed: int, topic: str) -> list[Any]:
    """Return what the judge publishes on a topic in one draw."""
    parts = load_exercise(exercise, ROOT).drawn(seed).plan.script.parts
    [part] = [one for one in parts if isinstance(one, Publishes) and one.topic == topic]
    return [line.value["data"] for line in part.lines]


def criteria(exercise: str) -> dict[str, Any]:
    return load_exercise(exercise, ROOT).criteria[-1].judge.__globals__


@pytest.mark.parametrize("seed", range(SEEDS))
def test_03_has_every_kind_of_level_as_often_as_the_task_tells(seed: int) -> None:
    made = criteria("03_publishers_and_messages")
    [line] = words("03_publishers_and_messages", seed, "/driver/calls")
    levels = line.splitlines()
    assert len(levels) == made["COUNT"]
    kinds = [*map(made["kind_of"], levels)]
    names = ("FLOAT", "EMPTY", "OTHER_NUMBER", "NO_NUMBER", "LOOK_ALIKE", "NOT_FINITE")
    assert [kinds.count(made[name]) for name in names] == [10, 2, 12, 6, 4, 6]
    once_more = made["AT_ONCE"] - 2
    assert levels[once_more - 1] == levels[once_more]
    assert made["number_in"](levels[once_more]) != made["number_in"](levels[once_more + 1]) is not None
    errors = [n for n, level in enumerate(levels) if made["number_in"](level) is None]
    assert any(later > error + 1 for error, later in pairwise(errors))
    assert errors[0] >= 6
    assert [kind for kind in kinds if kind in made["NUMBERS"]][-1] == made["FLOAT"]
    for before, kind in zip(levels, kinds[1:], strict=False):
        assert kind != made["NOT_FINITE"] or made["number_in"](before) not in (None, 100.0)
    assert levels[kinds.index(made["LOOK_ALIKE"])] in made["BOOLS"]


@pytest.mark.parametrize("seed", range(SEEDS))
def test_06_says_every_number_once(seed: int) -> None:
    made = criteria("06_spinning")
    said = [number for number in words("06_spinning", seed, "/robot/words") if number]
    assert len({*said}) == len(said) == made["BURST_WORDS"] + made["WAITING_WORDS"]
    jobs = words("06_spinning", seed, "/robot/jobs") + words("06_spinning", seed, "/worker/jobs")
    assert len({*jobs}) == len(jobs) == made["JOBS"] + made["JOBS_IN_A_ROW"]
    assert len({*words("06_spinning", seed, "/quiet/words")}) == made["QUIET_WORDS"]
    part = load_exercise("06_spinning", ROOT).drawn(seed).plan.script.parts[1]
    assert isinstance(part, Publishes)
    burst = [line.at for line in part.lines if line.value["data"]][: made["BURST_WORDS"]]
    assert len({*burst}) == 1 and 0.2 < burst[0] < 1.0


@pytest.mark.parametrize("seed", range(SEEDS))
def test_07_orders_the_same_calls_twice(seed: int) -> None:
    made = criteria("07_typed_nodes")
    first, second = (order.splitlines() for order in words("07_typed_nodes", seed, "/driver/go"))
    assert Counter(first) == Counter(second) and first != second
    wrong = {*made["WRONG_NUMBERS"], *made["WRONG_WORDS"], *made["WRONG_MESSAGES"]}
    assert wrong < {*first}
    for order in (first, second):
        levels = [(call, level) for call in order if (level := made["level_of"](call)) is not None]
        assert sorted(Counter(call for call, _ in levels).values()) == [1] * 7 + [2]
        assert sum(map(made["is_whole"], order)) == 1
        assert sum(0.0 < level < 1.0 for _, level in levels) == sum(level == 0.0 for _, level in levels) == 1
        assert sum(level > 99.75 for _, level in levels) == 1
        sent = [call for call, _ in levels if call.startswith("send_battery")]
        assert sent[-1] == sent[-2] and order.index(sent[-1]) + 1 == len(order) - 1 - order[::-1].index(
            sent[-1]
        )
        assert next(call for call in order if call in made["WRONG_WORDS"]) not in made["NO_TEXTS"]
        assert not {level for _, level in levels} & {*made["WRONG_LEVELS"]}
