"""Criteria tolerate every recording that a program can cause: none crashes, and none takes long."""

from collections.abc import Callable
from functools import cache
from random import Random
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.criteria.any_recording import (
    FOLDER,
    MOST_MESSAGES,
    ROOT,
    Flood,
    Strange,
    evenly,
    in_bursts,
    in_one_burst,
    right,
)
from workbook.criteria.runner import run_criteria
from workbook.exercise.definition import load_exercise
from workbook.exercise.source import stems
from workbook.watching.recorder import KEPT_PER_TOPIC

STEMS = stems(ROOT / "solutions")


read = cache(lambda stem: load_exercise(stem, ROOT))  # hypothesis requests the same recording repeatedly


@pytest.mark.parametrize("stem", STEMS)
@given(seed=st.integers(0, 2**32 - 1))
@settings(max_examples=40)
def test_no_criterion_crashes(stem: str, seed: int) -> None:
    exercise = read(stem)
    run_criteria(exercise.criteria, Strange(exercise, Random(seed)).recording(right(stem)))


@pytest.mark.parametrize(
    ("times", "strange"), [(evenly, False), (evenly, True), (in_bursts, False), (in_one_burst, False)]
)
@pytest.mark.parametrize("stem", STEMS)
@pytest.mark.whole
def test_no_criterion_takes_long(stem: str, times: Callable[[Random, float], float], strange: bool) -> None:
    """Even if a recording is full of messages and calls, all criteria together stay within their time budget."""
    exercise, random = load_exercise(stem, ROOT), Random(0)

    def change(value: Any) -> Any:
        return Strange(exercise, random).value(value) if strange else value

    run_criteria(exercise.criteria, Flood(exercise, random, times).flooded(right(stem), change))


def test_each_exercise_has_a_recording_and_the_limit_is_that_of_the_recorder() -> None:
    assert sorted(path.name for path in FOLDER.iterdir()) == [f"{stem}.json.gz" for stem in STEMS]
    assert MOST_MESSAGES == KEPT_PER_TOPIC
