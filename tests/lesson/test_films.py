"""Films on a page: they play, have a description, and are small enough for a notebook."""

import base64
import io
import math
from typing import Any

import IPython.display
import numpy as np
import pytest
from PIL import Image

from workbook.lesson import films
from workbook.pictures.film import film
from workbook.scenes.pinhole import Pinhole

SEEN = np.random.default_rng(1).integers(100, 140, (120, 160, 3)).astype(np.uint8)


@pytest.fixture
def shown(monkeypatch: pytest.MonkeyPatch) -> list[Any]:
    bundles: list[Any] = []
    monkeypatch.setattr(IPython.display, "display", lambda bundle, raw: bundles.append(bundle))
    return bundles


def test_a_film_plays_all_its_pictures_and_says_what_it_shows(shown: list[Any]) -> None:
    films.show_film([films.alone(SEEN), films.alone(SEEN // 2), films.alone(SEEN)], "a gray wall", 5)
    [bundle] = shown
    assert bundle["text/plain"] == "Film: a gray wall"
    assert 'alt="a gray wall"' in bundle["text/html"]
    moving = base64.b64decode(bundle["text/html"].split("webp;base64,")[1].split('"')[0])
    with Image.open(io.BytesIO(moving)) as moving_picture:
        assert (moving_picture.format, getattr(moving_picture, "n_frames", 1), moving_picture.size) == (
            "WEBP",
            3,
            (320, films.HEIGHT),
        )


def with_head(neck: float, ball: tuple[float, float] | None) -> Any:
    camera = Pinhole(640, 480, 560.0)
    with Image.open(io.BytesIO(films.with_head(SEEN, neck, ball, camera))) as both:
        return np.asarray(both).astype(int)


def middle_of(pixels: Any, red: range, blue: range) -> float:
    """Return the mean column of the drawing's pixels of a color; NaN if there are none."""
    found = np.isin(pixels[..., 0], red) & np.isin(pixels[..., 2], blue) & (pixels[..., 3] > 200)
    return float(np.nonzero(found[:100])[1].mean()) if found[:100].any() else math.nan


def test_next_to_the_picture_the_head_from_above_turns_with_the_neck_and_the_ball_lies_where_it_is() -> None:
    left, right = (with_head(neck, None)[:, 330:] for neck in (0.4, -0.4))
    arrow = {"red": range(40, 60), "blue": range(200, 220)}  # the palette's blue: #2f78d0
    assert middle_of(left, **arrow) < middle_of(right, **arrow) - 50
    ball = {"red": range(225, 240), "blue": range(15, 35)}
    assert math.isnan(middle_of(left, **ball))
    at_left, in_front, at_right = (
        middle_of(with_head(0.0, (column, 200.0))[:, 330:], **ball) for column in (180.0, 319.5, 460.0)
    )
    assert at_left < in_front - 20 < at_right - 40
    turned = middle_of(with_head(0.3, (319.5, 200.0))[:, 330:], **ball)
    assert turned < in_front - 20
    assert (with_head(0.0, None)[:, 160, :3] > 200).all()  # the center line


def test_pictures_of_a_camera_take_much_less_room_than_exact_ones() -> None:
    pictures = [films.alone(SEEN), films.alone(SEEN // 2)]
    exact, small = (len(film(pictures, per_second=5, exact=exact)) for exact in (True, False))
    assert 3 * small < exact
