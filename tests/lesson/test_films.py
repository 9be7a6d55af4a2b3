"""Films in a page: they play, have a description, and are small enough for a notebook."""

import base64
import io
from typing import Any

import IPython.display
import numpy as np
import pytest
from PIL import Image

from workbook.lesson import films
from workbook.pictures.film import film

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


def test_beside_the_picture_stands_the_robot() -> None:
    with Image.open(io.BytesIO(films.beside(SEEN, [0.0] * 12))) as both:
        pixels = np.asarray(both)
    assert pixels.shape[0] == films.HEIGHT
    assert (pixels[:, :320, 3] == 255).all()
    assert 0.05 < (pixels[:, 330:, 3] > 0).mean() < 0.95  # a figure on a clear ground


def test_pictures_of_a_camera_take_much_less_room_than_exact_ones() -> None:
    pictures = [films.alone(SEEN), films.alone(SEEN // 2)]
    exact, small = (len(film(pictures, per_second=5, exact=exact)) for exact in (True, False))
    assert 3 * small < exact
