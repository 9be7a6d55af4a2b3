import math
from functools import partial

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tests.pictures.reading import changed, colored, drawn, pixels
from workbook.pictures import humanoid, palette, png
from workbook.pictures.joints import (
    CHEER,
    COMFORTABLE,
    JOINT_NAMES,
    NEUTRAL,
    SQUAT,
    WAVE,
    Follower,
    checked,
    pose,
    skeleton,
    walking,
    waving,
)

draw = partial(humanoid.draw, scale=2.0)
placeholder = partial(humanoid.placeholder, scale=2.0)
MIDDLE = humanoid.WIDTH  # the image has two dots per pixel


def test_twelve_joints_in_a_documented_order_with_ranges() -> None:
    assert len(JOINT_NAMES) == 12 == len(set(JOINT_NAMES))
    assert JOINT_NAMES[0] == "neck"
    assert JOINT_NAMES[11] == "right_ankle"
    assert set(COMFORTABLE) == set(JOINT_NAMES)
    assert all(-math.pi < low < 0 < high < math.pi for low, high in COMFORTABLE.values())


@pytest.mark.parametrize("named", [NEUTRAL, WAVE, SQUAT, CHEER, walking(0.3), waving(0.2)])
def test_the_poses_that_we_ship_are_comfortable(named: tuple[float, ...]) -> None:
    for name, angle in zip(JOINT_NAMES, named, strict=True):
        low, high = COMFORTABLE[name]
        assert low <= angle <= high, name


def test_a_symmetrical_pose_is_drawn_symmetrically() -> None:
    for angles in (NEUTRAL, SQUAT, CHEER):
        outline = drawn(draw(angles))
        wrong = np.count_nonzero(outline != outline[:, ::-1]) / np.count_nonzero(outline)
        assert wrong < 0.004
    outline = drawn(draw(WAVE))
    assert np.count_nonzero(outline != outline[:, ::-1]) / np.count_nonzero(outline) > 0.05


@pytest.mark.parametrize(("joint", "left_of_picture"), [("left_shoulder", False), ("right_shoulder", True)])
def test_a_shoulder_moves_the_arm_on_its_own_side(joint: str, left_of_picture: bool) -> None:
    moved = changed(draw(pose()), draw(pose(**{joint: 1.2})))
    sides = np.count_nonzero(moved[:, :MIDDLE]), np.count_nonzero(moved[:, MIDDLE:])
    own, other = sides if left_of_picture else sides[::-1]
    assert own > 4000
    assert other < own / 20  # the eyes look to the other side
    assert np.count_nonzero(moved[660:, :]) == 0, "feet and ground stay where they were"


@pytest.mark.parametrize("index", range(12))
def test_each_of_the_twelve_joints_is_seen_to_move(index: int) -> None:
    angles = list(NEUTRAL)
    angles[index] += 0.4
    assert np.count_nonzero(changed(draw(NEUTRAL), draw(angles))) > 300


def test_an_angle_is_seen_as_the_angle_it_is() -> None:
    for angle in (0.0, 0.7, 1.5, -0.5):
        left, right = skeleton(pose(left_shoulder=angle, right_shoulder=angle)).arms
        across, up = left.bend[0] - left.root[0], left.bend[1] - left.root[1]
        assert math.atan2(across, -up) == pytest.approx(angle)
        assert right.bend[0] == pytest.approx(-left.bend[0])


@settings(max_examples=60, deadline=None)
@given(st.lists(st.floats(-math.pi, math.pi), min_size=12, max_size=12))
def test_the_lowest_point_of_any_pose_is_on_the_ground_and_all_is_on_the_picture(angles: list[float]) -> None:
    figure = skeleton(checked(angles))
    points = [figure.pelvis, figure.waist, figure.neck, figure.on_head(0, 100)]
    points += [point for limb in (*figure.arms, *figure.legs) for point in (limb.root, limb.bend, limb.end)]
    assert min(y for _, y in points) > 0
    assert max(y for _, y in points) < humanoid.HEIGHT
    assert max(abs(x) for x, _ in points) < humanoid.WIDTH / 2 + 20


@settings(max_examples=10, deadline=None)
@given(st.lists(st.floats(allow_nan=False, allow_infinity=False), min_size=12, max_size=12))
def test_any_finite_angle_can_be_drawn(angles: list[float]) -> None:
    assert png.size(draw(angles, panel=True)) == (
        2 * (humanoid.WIDTH + humanoid.PANEL),
        2 * humanoid.HEIGHT,
    )


@pytest.mark.parametrize(
    ("angles", "says"),
    [
        ([0.0] * 11, "needs 12 angles, not 11"),
        ([0.0] * 13, "needs 12 angles, not 13"),
        ([0.0] * 3 + [math.nan] + [0.0] * 8, "joint 3 (left_elbow) must be a finite number in rad, not nan"),
        ([math.inf] + [0.0] * 11, "joint 0 (neck)"),
        (["0.1"] + [0.0] * 11, "joint 0 (neck) must be a finite number in rad, not '0.1'"),
        ([None] * 12, "not None"),
        (3.0, "not a list of numbers: 3.0"),
    ],
)
def test_angles_that_cannot_be_drawn_are_named(angles: object, says: str) -> None:
    with pytest.raises(ValueError) as caught:  # noqa: PT011  the sentence is compared below
        draw(angles)  # type: ignore[arg-type]
    assert says in str(caught.value)


def test_numpy_and_float32_are_angles_too() -> None:
    same = draw(np.array(WAVE, dtype=np.float64))
    assert same == draw(WAVE)
    assert draw(np.array(WAVE, dtype=np.float32))


def test_the_lamp_tells_operational_from_error_by_more_than_color() -> None:
    dark, good, bad = (draw(NEUTRAL, lamp=lamp) for lamp in (None, "operational", "error"))
    assert (
        np.count_nonzero(colored(good, palette.GREEN)) > 400 > np.count_nonzero(colored(dark, palette.GREEN))
    )
    assert np.count_nonzero(colored(bad, palette.RED)) > 400 > np.count_nonzero(colored(good, palette.RED))
    middle = (slice(350, 384), slice(MIDDLE - 18, MIDDLE + 18))
    check, mark = (colored(picture, "#ffffff", 40)[middle] for picture in (good, bad))
    assert np.count_nonzero(check) > 60
    assert np.count_nonzero(mark) > 60
    assert np.count_nonzero(check != mark) > 100


def test_the_placeholder_shows_its_text_and_no_open_eyes() -> None:
    one, other = (
        placeholder("no message yet"),
        placeholder("waiting for /robot/joint_positions"),
    )
    moved = changed(one, other)
    assert np.count_nonzero(moved[2 * 400 :]) > 200
    assert np.count_nonzero(moved[: 2 * 395]) == 0
    assert (
        np.count_nonzero(colored(one, "#7fd0ff")) < 50 < np.count_nonzero(colored(draw(NEUTRAL), "#7fd0ff"))
    )


def test_the_panel_marks_values_beyond_the_ranges() -> None:
    calm = draw(pose(), panel=True)
    beyond = draw(pose(neck=0.0, left_elbow=4.0), panel=True)
    panel = slice(2 * humanoid.WIDTH, None)
    assert np.count_nonzero(colored(calm, palette.RED)[:, panel]) == 0
    row = np.nonzero(colored(beyond, palette.RED)[:, panel])[0]
    assert len(row) > 100
    assert 2 * (52 + 3 * 29 - 16) < row.min() <= row.max() < 2 * (52 + 3 * 29 + 8), (
        "the mark is in the row of joint 3"
    )


def test_the_ground_of_the_picture_is_transparent() -> None:
    image = pixels(draw(NEUTRAL))
    assert image[0, 0, 3] == image[0, -1, 3] == image[500, 40, 3] == 0


def test_the_same_angles_give_the_same_bytes() -> None:
    assert draw(SQUAT, lamp="error") == draw(SQUAT, lamp="error")


def test_the_follower_glides_and_arrives() -> None:
    follower = Follower(ease=1.0, start=pose())
    follower.aim(pose(neck=1.0), now=10.0)
    path = [follower.angles(10.0 + part / 10)[0] for part in range(12)]
    assert path[0] == 0.0
    assert path == sorted(path)
    assert path[5] == pytest.approx(0.5)
    assert path[10] == path[11] == 1.0


def test_the_follower_sets_out_from_where_it_is() -> None:
    follower = Follower(ease=1.0, start=pose())
    follower.aim(pose(neck=1.0), now=0.0)
    follower.aim(pose(neck=-1.0), now=0.5)
    assert follower.angles(0.5)[0] == pytest.approx(0.5)
    assert follower.angles(1.5)[0] == -1.0


def test_the_follower_keeps_its_aim_when_a_message_is_broken() -> None:
    follower = Follower(ease=0.0, start=pose())
    follower.aim(pose(waist=0.3), now=0.0)
    with pytest.raises(ValueError, match="12 angles, not 2"):
        follower.aim([0.0, 0.0], now=1.0)
    assert follower.angles(2.0) == pose(waist=0.3)


def test_a_joint_that_does_not_exist_is_named() -> None:
    with pytest.raises(ValueError, match="no joint is called 'tail'"):
        pose(tail=1.0)
