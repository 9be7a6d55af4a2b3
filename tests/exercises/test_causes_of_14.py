"""Exercise 14 on a recording of a right answer with one fault, which loses what the table says."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from tests.criteria.any_recording import ROOT, right
from workbook.criteria.runner import run_criteria
from workbook.exercise.definition import load_exercise

STEM, FILTERED = "14_arrays_and_filters", "/robot/joint_states"
EXERCISE = load_exercise(STEM, ROOT)
CRITERIA, GIVEN = EXERCISE.criteria, EXERCISE.constants
Value = dict[str, Any]


def lost(change: Callable[[int, Value], Value]) -> dict[str, str]:
    """Change each answer, given its number and fields. Return the criteria that don't pass, with their causes."""
    seen = right(STEM)
    topic = seen.topic(FILTERED)
    arrivals = tuple(
        replace(one, value=change(number, one.value)) for number, one in enumerate(topic.arrivals)
    )
    changed = replace(seen, topics={**seen.topics, FILTERED: replace(topic, arrivals=arrivals)})
    return {
        one.id: one.cause or one.status for one in run_criteria(CRITERIA, changed) if one.status != "passed"
    }


def stamped(value: Value, sec: int, nanosec: int = 0) -> Value:
    return {**value, "header": {**value["header"], "stamp": {"sec": sec, "nanosec": nanosec}}}


def with_first_stamp(number: int, value: Value) -> Value:
    first = right(STEM).topic(FILTERED).arrivals[0].value["header"]["stamp"]
    return stamped(value, **first)


FAULTS: dict[str, Callable[[int, Value], Value]] = {
    "labels-kept.one-stamp": with_first_stamp,
    "labels-kept.no-stamp": lambda number, value: stamped(value, 0),
    "labels-kept.own-stamp": lambda number, value: stamped(value, 1_700_000_000 + number),
    "labels-kept.no-names": lambda number, value: {**value, "name": []},
    "labels-kept.other-order": lambda number, value: {**value, "name": sorted(value["name"])},
    "labels-kept.other-names": lambda number, value: {**value, "name": ["head", *value["name"][1:]]},
}


@pytest.mark.parametrize("cause", FAULTS)
def test_a_wrong_name_or_stamp_costs_its_point_alone(cause: str) -> None:
    assert lost(FAULTS[cause]) == {"labels_kept": cause}


def test_a_filter_is_judged_whatever_the_names_are() -> None:
    def passed_on(number: int, value: Value) -> Value:
        measured = right(STEM).published[number].value["position"]
        return {**value, "name": [], "position": measured}

    found = lost(passed_on)
    assert found["labels_kept"] == "labels-kept.no-names" and found["filters"] == "filters.passes-through"


def test_an_angle_alone_is_not_judged_as_a_filter() -> None:
    found = lost(lambda number, value: {**value, "position": value["position"][:1]})
    assert found["labels_kept"] == "labels-kept.other-length"
    assert set(found.values()) == {"labels-kept.other-length", "skipped"}


def test_infinite_angles_of_both_signs_are_told() -> None:
    def infinite(number: int, value: Value) -> Value:
        return {**value, "position": [math.inf if number % 2 else -math.inf, *value["position"][1:]]}

    assert lost(infinite)["noise_reduced"] == "noise-reduced.no-number"


def test_a_program_that_ended_before_the_restart_is_not_said_to_miss_it() -> None:
    seen = right(STEM)
    topic, messages = seen.topic(FILTERED), [one.value for one in seen.published]
    each_second = [
        replace(one, value=message if message["header"]["stamp"]["nanosec"] == 0 else one.value)
        for one, message in zip(topic.arrivals[:150], messages, strict=False)
    ]
    ended = replace(
        seen,
        topics={**seen.topics, FILTERED: replace(topic, arrivals=tuple(each_second))},
        process=replace(seen.process, ended_by="itself", exit=0, ended_at=topic.arrivals[150].wall),
    )
    found = {one.id: one.cause for one in run_criteria(CRITERIA, ended)}
    assert found["restart_noticed"] == "silence.program-ended"


class TestTheMessagesThatTheJudgeSends:
    def test_a_nan_comes_while_the_joints_stand_again(self) -> None:
        stands_again = range(GIVEN["STANDS"] + GIVEN["MOVES"], GIVEN["STILL_UNTIL"])
        assert all(place in stands_again for place in GIVEN["NAN_AT"])

    def test_noise_is_measured_in_the_standstills_that_the_task_tells(self) -> None:
        restart, settled = GIVEN["RESTART"], GIVEN["SETTLED"]
        assert set(GIVEN["STEADY"]) == {
            *range(settled, GIVEN["STANDS"]),
            *range(
                restart + settled, GIVEN["RESTART_AGAIN"] - 4
            ),  # answers just before a restart may contain samples from before and after it
        }

    def test_neither_nanosec_alone_nor_rising_stamps_show_a_restart(self) -> None:
        for start in (GIVEN["RESTART"], GIVEN["RESTART_AGAIN"]):
            before, after = (GIVEN["SAMPLES"][start + n].stamp for n in (-1, 0))
            assert after < before and after[1] > before[1]

    def test_each_has_its_own_stamp_and_no_group_divides_their_number(self) -> None:
        samples = GIVEN["SAMPLES"]
        assert len({sample.stamp for sample in samples}) == len(samples)
        assert all(len(samples) % size for size in range(2, len(samples)))
