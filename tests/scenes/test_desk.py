"""Images of the desk: the same for the same seed, and everything where the geometry puts it."""

import numpy as np
import pytest

from workbook.scenes.desk import DeskCamera
from workbook.scenes.encodings import encoded
from workbook.scenes.painting import Picture, paint_sphere
from workbook.scenes.pinhole import Pinhole, Vector
from workbook.scenes.scene import BALL_RADIUS_M, Box, Scene, on_desk

SMALL = Pinhole(160, 120, 140.0)
JOINTS = (0.0, 0.0, 0.9, 0.9, 0.8, 0.8, *[0.0] * 6)
FULL = Scene(on_desk(0.7, 0.1), on_desk(0.9, -0.2), (Box((0.95, 0.3), turn=0.4),), JOINTS, 0.1, 0.8, 1.1)


def orange_center(picture: Picture) -> tuple[float, float]:
    """Return the center of the orange pixels, weighted by how orange they are."""
    wide = picture.astype(float) + 1.0
    weight = np.clip(
        (wide[..., 0] - wide[..., 2]) / wide[..., 0] - 0.2, 0.0, 0.5
    )  # the same in light and in shade
    rows, columns = np.indices(weight.shape)
    return float((columns * weight).sum() / weight.sum()), float((rows * weight).sum() / weight.sum())


def ellipse_center(pinhole: Pinhole, ball: Vector) -> tuple[float, float]:
    """Return the center of a ball's outline in the image, which is slightly farther out than the ball's center."""
    (u, v), middle = pinhole.pixel(ball), pinhole.center
    shift = 1.0 / (1.0 - (BALL_RADIUS_M / ball[2]) ** 2)
    return middle[0] + shift * (u - middle[0]), middle[1] + shift * (v - middle[1])


def test_the_same_seed_gives_the_same_bytes() -> None:
    one, other = DeskCamera(SMALL, 15), DeskCamera(SMALL, 15)
    one.picture(FULL, 3)  # an earlier image has no effect
    assert one.picture(FULL, 7).tobytes() == other.picture(FULL, 7).tobytes()


def test_another_number_or_seed_gives_other_noise() -> None:
    camera = DeskCamera(SMALL, 15)
    first = camera.picture(FULL, 1)
    assert first.tobytes() != camera.picture(FULL, 2).tobytes()
    assert first.tobytes() != DeskCamera(SMALL, 16).picture(FULL, 1).tobytes()


@pytest.mark.parametrize("place", [(0.6, 0.0), (0.7, 0.1), (0.8, -0.25), (0.95, 0.3)])
@pytest.mark.parametrize("pinhole", [SMALL, Pinhole()], ids=["160x120", "640x480"])
def test_a_ball_covers_the_pixels_that_look_at_it(pinhole: Pinhole, place: tuple[float, float]) -> None:
    white = np.full((pinhole.height, pinhole.width, 3), 255, np.uint8)
    center = pinhole.seen_from(on_desk(*place))
    paint_sphere(white, pinhole, center, BALL_RADIUS_M, (0.0, 0.0, 0.0))
    cover = 1.0 - white[..., 0] / 255
    rows, columns = np.indices(cover.shape)
    rays = np.stack(
        [(columns - pinhole.center[0]), (rows - pinhole.center[1]), np.full(cover.shape, pinhole.focal)], -1
    )
    rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
    beside = np.linalg.norm(np.cross(rays, center), axis=-1)
    pixel_m = float(center[2]) / pinhole.focal
    assert (cover[beside < BALL_RADIUS_M - pixel_m] == 1.0).all()
    assert (cover[beside > BALL_RADIUS_M + pixel_m] == 0.0).all()
    seen = float((cover * columns).sum() / cover.sum()), float((cover * rows).sum() / cover.sum())
    assert seen == pytest.approx(ellipse_center(pinhole, center), abs=0.05)


@pytest.mark.parametrize("pinhole", [SMALL, Pinhole()], ids=["160x120", "640x480"])
@pytest.mark.parametrize("place", [(0.6, 0.0), (0.7, 0.1), (0.8, -0.25), (0.95, 0.3)])
def test_the_ball_is_where_the_pinhole_model_says(pinhole: Pinhole, place: tuple[float, float]) -> None:
    picture = DeskCamera(pinhole, 15, noise=0.0).picture(Scene(on_desk(*place)), 0)
    center = pinhole.seen_from(on_desk(*place))
    wanted = ellipse_center(pinhole, center)
    # The ball's visible lower edge is dark, so the test's estimate is slightly too high.
    assert orange_center(picture) == pytest.approx(wanted, abs=0.35)


def test_a_ball_moves_by_parts_of_a_pixel() -> None:
    camera = DeskCamera(SMALL, 15, noise=0.0)
    left = [on_desk(0.7, 0.001 * n) for n in range(6)]
    seen = [orange_center(camera.picture(Scene(place), 0))[0] for place in left]
    steps = -np.diff(seen)
    assert steps == pytest.approx(np.full(5, steps.mean()), abs=0.06)
    assert 0.1 < steps.mean() < 0.3


def test_a_head_that_turns_left_sees_the_ball_further_right() -> None:
    camera = DeskCamera(SMALL, 15, noise=0.0)
    ahead, turned = (
        orange_center(camera.picture(Scene(on_desk(0.7, 0.0), pan=pan), 0)) for pan in (0.0, 0.2)
    )
    assert turned[0] > ahead[0] + 15


def test_joints_move_the_hands() -> None:
    camera = DeskCamera(SMALL, 15, noise=0.0)
    higher = (*JOINTS[:3], JOINTS[3] + 0.4, *JOINTS[4:])
    here, there = (camera.picture(Scene(joints=joints), 0).astype(int) for joints in (JOINTS, higher))
    changed = np.abs(here - there).max(axis=2) > 20
    assert changed[:, :80].sum() > 100  # the left arm
    assert changed[:, 110:].sum() == 0


def test_light_and_noise_are_what_was_asked_for() -> None:
    wall = [DeskCamera(SMALL, 15).picture(Scene(light=light), 1)[:15].astype(float) for light in (1.0, 0.4)]
    assert wall[1].mean() / wall[0].mean() == pytest.approx(0.4, abs=0.02)
    still = DeskCamera(SMALL, 15, noise=0.0).picture(Scene(), 1).astype(float)
    assert (DeskCamera(SMALL, 15).picture(Scene(), 1) - still).std() == pytest.approx(4.0, abs=0.2)


def test_things_outside_the_picture_or_behind_the_head_change_nothing() -> None:
    camera = DeskCamera(SMALL, 15)
    empty = camera.picture(Scene(), 1)
    for place in ((0.7, 5.0), (-0.7, 0.0)):
        box = Box((place[0], place[1] / 2))
        assert (camera.picture(Scene(on_desk(*place), boxes=(box,)), 1) == empty).all()


def test_encodings_and_padding() -> None:
    picture = DeskCamera(SMALL, 15).picture(FULL, 1)
    for encoding, channels in (("rgb8", 3), ("bgr8", 3), ("rgba8", 4), ("mono8", 1)):
        data, step = encoded(picture, encoding, padding=32)
        assert (len(data), step) == (120 * step, 160 * channels + 32)
        pixels = (
            np.frombuffer(data, np.uint8).reshape(120, step)[:, : 160 * channels].reshape(120, 160, channels)
        )
        opaque = np.dstack([picture, np.full((120, 160), 255, np.uint8)])
        wanted = {"rgb8": picture, "bgr8": picture[..., ::-1], "rgba8": opaque}.get(encoding)
        if wanted is not None:
            assert (pixels == wanted).all()
        else:
            assert np.abs(pixels[..., 0] - picture.astype(float).mean(axis=2)).mean() < 10
    with pytest.raises(ValueError, match="not '32FC1'"):
        encoded(picture, "32FC1")


def test_numbers_of_16_bits_and_brightness_with_color_differences() -> None:
    picture = DeskCamera(SMALL, 15).picture(FULL, 1)
    gray = picture @ np.array([0.299, 0.587, 0.114])
    data, step = encoded(picture, "mono16")
    assert step == 320
    assert np.frombuffer(data, "<u2").reshape(120, 160) == pytest.approx(257 * gray, abs=1)
    data, step = encoded(picture, "yuv422_yuy2", padding=2)
    assert step == 322
    assert np.frombuffer(data, np.uint8).reshape(120, 322)[:, :320:2] == pytest.approx(gray, abs=1)


def test_the_desk_of_lesson_15_has_not_changed() -> None:
    """The brightness of sixteen parts of an image, from before the desk got cups and plates."""
    parts = DeskCamera(SMALL, 15).picture(FULL, 7).reshape(4, 30, 4, 40, 3).mean(axis=(1, 3, 4))
    told = [
        [131.435, 129.574, 129.639, 131.332],
        [103.392, 99.851, 100.703, 100.259],
        [105.051, 99.008, 100.549, 104.887],
        [106.639, 117.272, 98.906, 106.657],
    ]
    assert parts == pytest.approx(np.array(told), abs=0.01)
