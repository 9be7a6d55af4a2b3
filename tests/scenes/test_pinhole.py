"""The pinhole model: where a point appears, and in which direction a pixel looks."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as some

from workbook.scenes.pinhole import Pinhole

CAMERA = Pinhole()


def test_what_is_straight_ahead_is_seen_in_the_middle() -> None:
    ahead = CAMERA.seen_from((math.cos(CAMERA.pitch), 0.0, -math.sin(CAMERA.pitch)))
    assert ahead == pytest.approx([0.0, 0.0, 1.0])
    assert CAMERA.pixel(ahead) == pytest.approx((319.5, 239.5))


def test_left_is_left_and_up_is_up() -> None:
    left, up = (
        CAMERA.pixel(CAMERA.seen_from((1.0, 0.2, -0.5))),
        CAMERA.pixel(CAMERA.seen_from((1.0, 0.0, -0.3))),
    )
    middle = CAMERA.pixel(CAMERA.seen_from((1.0, 0.0, -0.5)))
    assert left[0] < middle[0]
    assert up[1] < middle[1]


def test_a_head_that_turns_to_a_point_sees_it_in_the_middle_column() -> None:
    seen = CAMERA.seen_from((0.8, 0.3, -0.4), pan=math.atan2(0.3, 0.8))
    assert CAMERA.pixel(seen)[0] == pytest.approx(319.5)


@given(some.floats(-20, 660), some.floats(-20, 500), some.floats(0.1, 50.0))
def test_the_direction_of_a_pixel_leads_back_to_it(column: float, row: float, far: float) -> None:
    ray = CAMERA.direction(column, row)
    assert np.linalg.norm(ray) == pytest.approx(1.0)
    assert CAMERA.pixel(far * ray) == pytest.approx((column, row), abs=1e-6)


def test_what_is_behind_the_camera_is_refused() -> None:
    with pytest.raises(ValueError, match="in front"):
        CAMERA.pixel(np.array([0.0, 0.0, -1.0]))


@pytest.mark.parametrize("pan", [0.0, 0.4, -0.6])
def test_a_pixel_of_a_level_plane_leads_back_to_its_place(pan: float) -> None:
    camera = Pinhole()
    pixel = camera.pixel(camera.seen_from((0.9, 0.2, -0.41), pan))
    assert camera.on_level(*pixel, -0.41, pan) == pytest.approx((0.9, 0.2))


def test_a_ray_above_the_horizon_does_not_meet_the_plane() -> None:
    assert Pinhole(pitch=0.0).on_level(319.5, 100.0, -0.41) is None
