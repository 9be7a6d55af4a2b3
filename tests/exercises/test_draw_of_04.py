"""Exercise 04's readings: every draw has the properties that its criteria and causes rely on."""

import math
from itertools import pairwise
from typing import Any

import pytest
from rclpy.serialization import deserialize_message, serialize_message
from std_msgs.msg import Float32

from tests.exercises.proofs import ROOT, SEEDS
from workbook.exercise.definition import Exercise, load_exercise
from workbook.recording.script import Publishes

EXERCISE = load_exercise("04_subscriptions_and_callbacks", ROOT)
CRITERIA = EXERCISE.criteria[-1].judge.__globals__


def lines(exercise: Exercise) -> tuple[list[tuple[float, float]], list[float]]:
    """Return the readings with their times (s), and the other robot's readings."""
    ours, others = exercise.plan.script.parts
    assert isinstance(ours, Publishes) and isinstance(others, Publishes)
    return [(one.at, one.value["data"]) for one in ours.lines], [one.value["data"] for one in others.lines]


@pytest.fixture(params=range(SEEDS))
def sent(request: pytest.FixtureRequest) -> Any:
    """Return the readings of one draw, in the form that the criteria use."""
    readings, others = lines(EXERCISE.drawn(request.param))
    return CRITERIA["Readings"](
        tuple(value for _, value in readings), tuple(at for at, _ in readings), tuple(others)
    )


def test_the_task_holds_in_every_draw(sent: Any) -> None:
    assert (len(sent.good), len(sent.bad)) == (CRITERIA["LAST_GOOD"], CRITERIA["BAD_ONES"])
    gaps = [later - at for at, later in pairwise(sent.sent_at)]
    assert sum(gap < CRITERIA["MOMENT_S"] for gap in gaps) == CRITERIA["AT_ONE_MOMENT"] - 1
    assert len(sent.in_a_moment) == CRITERIA["AT_ONE_MOMENT"]
    assert sum(gap > 0.25 for gap in gaps) == 1


def test_every_kind_of_reading_is_in_every_draw(sent: Any) -> None:
    assert sent.good.count(0.0) == sent.good.count(100.0) == 1
    assert sent.changes.count(0.0) == 2
    assert sum(abs(change) > CRITERIA["JUMP"] for change in sent.changes) >= 3
    assert sum(one <= CRITERIA["LOW_AT_MOST"] for one in sent.good) == 4
    assert sum(0.0 < one < 1.0 for one in sent.good) == 1
    assert len(sent.near_limits) == 3
    assert {-math.inf, math.inf, CRITERIA["EXAMPLE"]} < set(sent.bad)
    assert sum(map(math.isnan, sent.bad)) == 2
    assert any(100.5 < one < 200.0 for one in sent.bad)
    assert any(1e6 < one < math.inf for one in sent.bad)
    assert len(sent.bad_in_a_row) == len(sent.sent_before) == 3
    assert sent.bad_in_a_row != sent.sent_before


def test_what_happens_beside_a_bad_reading_tells_one_cause_from_another(sent: Any) -> None:
    first_bad, last_good = sent.bad_places[0], sent.good_places[-1]
    assert 2 <= first_bad < len(sent.good) // 2
    assert sent.bad_places[-1] == last_good + 1 == len(sent.readings) - 1
    assert not all(math.isfinite(one) for one in sent.bad)
    assert math.isfinite(sent.bad[0])
    assert math.isnan(next(one for one in sent.bad if not math.isfinite(one)))
    for place in sent.bad_places:
        assert sent.readings[place + 1 : place + 2] not in [(0.0,), (100.0,)]
    rows = [place for place in sent.bad_places if place - 1 not in sent.bad_places]
    for row, later in pairwise(rows):
        between = [n for n in sent.good_places if row < n < later]
        assert len({sent.readings[n] for n in between}) >= 2


def test_no_reading_is_taken_for_one_of_the_other_robot(sent: Any) -> None:
    assert len(sent.others) == 3 and sum(map(CRITERIA["is_good"], sent.others)) == 2
    assert not {8.0 * one % 2.0 for one in sent.others} - {1.0}
    assert not set(sent.others) & {abs(one) for one in sent.readings}


def test_readings_are_kept_in_32_bits_as_they_are(sent: Any) -> None:
    for one in (*sent.readings, *sent.others):
        kept = deserialize_message(serialize_message(Float32(data=one)), Float32).data
        assert kept == one or math.isnan(one)
