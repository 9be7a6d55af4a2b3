"""Exercise 14 on a recording of a right answer with one fault: it costs what the table says for it."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from tests.criteria.any_recording import ROOT, right
from workbook.criteria.runner import run_criteria
from workbook.exercise.definition import load_exercise

STEM, FILTERED = "14_arrays_and_filters", "/robot/joint_states"
CRITERIA = load_exercise(STEM, ROOT).criteria
Value = dict[str, Any]


def lost(change: Callable[[int, Value], Value]) -> dict[str, str]:
    """What is not passed, and why, where each answer is changed: its number and its fields."""
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
