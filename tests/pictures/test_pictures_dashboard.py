import math

import numpy as np
import pytest

from tests.pictures.reading import changed, colored
from workbook.pictures import dashboard, palette, png

ARRIVALS = {"/robot/status": [1.0, 2.0, 3.0, 4.0], "/robot/battery": [2.0, 4.0]}
LAMP = (slice(0, 2 * 90), slice(0, 2 * 84))
GAUGE = (slice(2 * 20, 2 * 78), slice(2 * 280, 2 * 404))
ROW = dashboard.ROW * 2


def draw(status: str | None = "operational", battery: float | None = 80.0, now: float = 5.0) -> bytes:
    return dashboard.draw(status, battery, ARRIVALS, now=now)


@pytest.mark.parametrize(
    ("status", "color"),
    [
        ("operational", palette.GREEN),
        ("error", palette.RED),
        ("rebooting", palette.AMBER),
        (None, palette.GREY),
    ],
)
def test_the_lamp_has_the_color_of_the_status(status: str | None, color: str) -> None:
    lamp = draw(status)
    counts = {
        tint: np.count_nonzero(colored(lamp, tint)[LAMP])
        for tint in (palette.GREEN, palette.RED, palette.AMBER, palette.GREY)
    }
    assert max(counts, key=lambda tint: counts[tint]) == color
    assert np.count_nonzero(colored(lamp, "#ffffff")[LAMP]) > 20, "a sign stands in the lamp"


def test_the_word_stands_beside_the_lamp() -> None:
    words = (slice(0, 2 * 90), slice(2 * 90, 2 * 276))
    assert np.count_nonzero(changed(draw("operational"), draw("operative"))[words]) > 100


def test_the_gauge_is_filled_in_proportion() -> None:
    full, half = (
        np.count_nonzero(colored(draw(battery=level), palette.GREEN)[GAUGE]) for level in (100.0, 60.0)
    )
    assert half / full == pytest.approx(0.6, abs=0.04)


@pytest.mark.parametrize(
    ("battery", "color"), [(80.0, palette.GREEN), (35.0, palette.AMBER), (12.0, palette.RED)]
)
def test_the_gauge_warns(battery: float, color: str) -> None:
    assert np.count_nonzero(colored(draw(battery=battery), color)[GAUGE]) > 300


@pytest.mark.parametrize("battery", [-5.0, 140.0, math.nan, math.inf])
def test_impossible_batteries_are_shown_and_marked(battery: float) -> None:
    words = (slice(2 * 40, 2 * 70), slice(2 * 420, None))
    assert np.count_nonzero(colored(draw(battery=battery), palette.RED)[words]) > 100


def test_before_the_first_message() -> None:
    empty = dashboard.draw(None, None, {"/robot/status": [], "/robot/battery": []}, now=0.0)
    for color in (palette.GREEN, palette.RED, palette.AMBER, palette.BLUE):
        assert np.count_nonzero(colored(empty, color)) == 0


def marks(picture: bytes, row: int, color: str) -> int:
    """Return how many separate marks a row of the timeline has."""
    top = 2 * 104 + row * ROW
    columns = colored(picture, color, 40)[top : top + ROW, 2 * 130 : 2 * 505].any(axis=0).astype(int)
    return int(np.count_nonzero(np.diff(np.concatenate(([0], columns))) == 1))


def test_each_arrival_in_the_window_has_a_mark() -> None:
    solid = dashboard.draw("error", 80.0, {"/robot/status": [9.0, 9.5], "/robot/battery": [9.2]}, now=10.0)
    assert marks(solid, 0, palette.BLUE) == 2
    assert marks(solid, 1, palette.BLUE) == 1


def test_old_arrivals_leave_the_window_and_future_ones_are_not_shown() -> None:
    times = {"/robot/status": [1.0, 19.5, 25.0]}
    picture = dashboard.draw("operational", 80.0, times, now=20.0, window=2.0)
    assert marks(picture, 0, palette.BLUE) == 1


def test_marks_wander_to_the_left() -> None:
    def column(now: float) -> float:
        row = colored(
            dashboard.draw(None, None, {"/robot/status": [4.0]}, now=now, window=10), palette.BLUE, 40
        )
        return float(np.nonzero(row[2 * 104 : 2 * 104 + ROW].any(axis=0))[0].mean())

    assert column(4.5) - column(5.5) == pytest.approx(2 * (dashboard.WIDTH - 150 - 58) / 10, abs=3)


def test_it_grows_with_the_topics_and_a_fast_topic_stays_cheap() -> None:
    one = dashboard.draw(None, None, {"/a": []}, now=0)
    three = dashboard.draw(None, None, {"/a": [], "/b": [], "/c": [i / 1000 for i in range(9999)]}, now=10)
    assert png.size(three)[1] - png.size(one)[1] == 2 * ROW


def test_a_window_of_nothing_is_refused() -> None:
    with pytest.raises(ValueError, match="longer than 0 s"):
        dashboard.draw(None, None, {}, now=0, window=0)
