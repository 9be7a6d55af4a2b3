"""Moving images: what they show at a moment, and that they are small enough for a notebook."""

import io

import pytest
from PIL import Image

from workbook.pictures import egg, moving
from workbook.pictures.film import moving_png
from workbook.pictures.timeline import Row

MOST_BYTES = 400_000
BEATS = [0.1 * n for n in range(1, 50)]
BLOCKED = [t for t in BEATS if not 1.1 < t < 2.1 and not 3.2 < t < 4.2]


def frames(png: bytes) -> int:
    """Return how many frames a moving image has."""
    return int(getattr(Image.open(io.BytesIO(png)), "n_frames", 1))


def test_two_robots_move_and_fit_into_a_notebook() -> None:
    film = moving.robots(
        moving.by_name({"blocked": BLOCKED, "rescued": BEATS}, period=0.1), "two robots", end=5.0
    )
    assert frames(film.png) > 20
    assert len(film.png) < MOST_BYTES


def test_a_robot_is_late_only_while_a_beat_is_missing() -> None:
    robot = moving.Robot("robot", BLOCKED, period=0.1)
    assert [moving.is_late(robot, now) for now in (1.0, 1.25, 1.5, 2.15, 3.0)] == [
        False,
        False,
        True,
        False,
        False,
    ]


def test_a_robot_without_a_beat_is_late() -> None:
    assert moving.is_late(moving.Robot("robot", [], period=0.1), 1.0)


def test_marks_are_played_back_to_the_end() -> None:
    rows = [Row("heartbeat", [0.5, 1.0, 1.5], period=0.5, start=0.0), Row("missed", [])]
    film = moving.played_back(rows, "three beats", end=2.0, title="three beats came")
    assert frames(film.png) > 5
    assert len(film.png) < MOST_BYTES


def test_moments_begin_at_zero_and_end_at_the_end() -> None:
    found = moving.moments(5.0, pace=1.0)
    assert (found[0], found[-1]) == (0.0, 5.0)
    assert found == sorted(found)


@pytest.mark.parametrize(
    ("late_ms", "after_touch_ms", "squeezed"),
    [(1.0, 30.0, 0.1), (40.0, 10.0, 1.0), (40.0, 90.0, 4.0), (5.0, -3.0, 0.0)],
)
def test_fingers_close_until_the_report(late_ms: float, after_touch_ms: float, squeezed: float) -> None:
    assert egg.squeezed_mm(late_ms, after_touch_ms) == pytest.approx(squeezed)


def test_the_egg_moves_and_fits_into_a_notebook() -> None:
    film = egg.squeeze({"by callback": 1.0, "by polling": 30.0}, "two eggs")
    assert frames(film.png) > 10
    assert len(film.png) < MOST_BYTES


def test_a_film_needs_a_picture() -> None:
    with pytest.raises(ValueError, match="at least one"):
        moving_png([], per_second=8.0, dots_per_pixel=1.0)
