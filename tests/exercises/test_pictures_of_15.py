"""The images for exercise 15: drawn for each run, and always with everything that the criteria require."""

import math
from functools import cache
from itertools import combinations, pairwise
from typing import Any

import pytest

from tests.exercises.proofs import SEEDS
from workbook.criteria import seen_pixel, things_seen
from workbook.exercise.course import course_folder
from workbook.exercise.definition import load_exercise

STEM = "15_camera"
EVERY = 3
"""Check only every third image: ten of the thirty per second are enough."""
NEAR_PIXELS = 25.0
"""The search radius of the wrong answer that searches only near the last ball."""


@cache
def judge() -> dict[str, Any]:
    """Return the names that the criteria file defines."""
    return load_exercise(STEM, course_folder()).criteria[-1].judge.__globals__


@pytest.fixture(params=range(SEEDS))
def pictures(request: pytest.FixtureRequest) -> Any:
    """Return the images of one run."""
    return judge()["drawn"](request.param)


def test_the_ball_is_above_and_below_the_brick_and_wider_and_narrower(pictures: Any) -> None:
    seen = [
        {thing.label: thing for thing in things_seen(pictures.views[place].scene)}
        for place in pictures.with_ball
    ]
    assert {things["ball"].v < things["brick"].v for things in seen} == {True, False}
    assert {things["ball"].width < things["brick"].height for things in seen} == {True, False}


def test_the_ball_is_whole_wide_enough_and_apart_from_the_brick(pictures: Any) -> None:
    for place in pictures.with_ball[::EVERY]:
        seen = {one.label: one for one in things_seen(pictures.views[place].scene)}
        ball, brick = seen["ball"], seen.get("brick")
        assert ball.visible == 1.0 and ball.width >= 11.0
        if brick is not None:
            sideways = abs(ball.u - brick.u) - (ball.width + brick.width) / 2
            assert max(sideways, abs(ball.v - brick.v) - (ball.height + brick.height) / 2) >= 4.0


def test_all_kinds_come_and_in_an_order_that_tells_mistakes_apart(pictures: Any) -> None:
    nothing = judge()["NOTHING"].words
    assert len(pictures.views) == judge()["PICTURES"] and f"{len(pictures.views)} images" in nothing["saw"]
    assert f"{len(pictures.readable)} readable images" in nothing["expected"]
    assert (
        len(pictures.without_ball) <= 36
    )  # a program that publishes nothing for these images still keeps up
    first = pictures.first_other
    assert pictures.views[0].encoding == "rgb8" and pictures.views[first - 1].encoding == "bgr8"
    for kind in (pictures.in_good_light, pictures.in_dim_light, pictures.in_bgr, pictures.without_ball):
        assert 2 * sum(place < first for place in kind) >= len(kind)
    assert min(pictures.padded + pictures.padded_bgr) == first + 4
    assert max(pictures.in_dim_light[0], pictures.in_good_light[0]) < pictures.without_ball[0]
    starts = [place for place in pictures.others if place - 1 not in pictures.others]
    refused = sorted(pictures.views[place].encoding for place in starts)
    *most, last = refused
    told = f"{len(pictures.others)} images were encoded as {', '.join(most)}, or {last}:"
    assert judge()["REFUSED_WELL"].words["saw"].startswith(told)
    assert min(b - a for a, b in pairwise(starts)) >= 1.1 * judge()["RATE_HZ"]  # a log may be throttled
    assert max(pictures.readable) > max(pictures.others)
    assert all(pictures.views[place].stamp[1] != 0 for place in pictures.others)


def test_the_ball_jumps_into_dim_light_and_into_bgr8_alone(pictures: Any) -> None:
    last, lost = None, set()
    for place in pictures.with_ball:
        at = seen_pixel(pictures.views[place].scene.ball)
        if last is not None and math.dist(at, last) > NEAR_PIXELS:
            lost.add(place)
        else:
            last = at
    assert lost & {*pictures.in_dim_light} and lost & {*pictures.in_bgr}
    assert not lost & {*pictures.in_good_light, *pictures.padded, *pictures.padded_bgr}


def test_a_table_of_one_run_is_hardly_ever_right_in_another() -> None:
    runs = [judge()["drawn"](seed) for seed in range(SEEDS)]
    lucky = 0
    for one, other in combinations(runs, 2):
        both = [place for place in one.in_good_light if place in other.balls]
        off = [one.balls[place].off_deg(other.balls[place]) for place in both]
        lucky += max(off) <= judge()["WITHIN_DEG"]
    assert lucky <= 0.02 * math.comb(SEEDS, 2)
