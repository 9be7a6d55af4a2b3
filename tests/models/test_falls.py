"""Episodes of a robot that stands, bows, is pushed, or falls: their contents, and how alarms are counted."""

import numpy as np
import pytest

from workbook.models.falls import (
    CHANNELS,
    KINDS,
    LENGTH_S,
    ON_THE_GROUND,
    RATE_HZ,
    WINDOW,
    Episode,
    alarms,
    all_windows,
    episodes,
    windows,
)

NEWEST_TILT = (WINDOW - 1) * len(CHANNELS)


def ramp(length: int, falls_from: int | None) -> Episode:
    """Make an episode whose tilt is the sample's number and whose other channels are 0."""
    samples = np.zeros((length, len(CHANNELS)))
    samples[:, 0] = np.arange(length)
    return Episode("stands" if falls_from is None else "falls", samples, falls_from)


def test_the_same_seed_brings_the_same_samples() -> None:
    one, same, other = episodes(7, 8), episodes(7, 8), episodes(8, 8)
    assert all(np.array_equal(a.samples, b.samples) for a, b in zip(one, same, strict=True))
    assert not np.array_equal(one[0].samples, other[0].samples)
    assert [episode.kind for episode in one] == [*KINDS, *KINDS]


def test_only_a_fall_ends_on_the_ground() -> None:
    for episode in episodes(3, 80):
        body = episode.samples[:, 0] - episode.samples[:, 2]
        if episode.kind == "falls":
            assert episode.falls_from is not None
            assert 0 < episode.falls_from < len(episode.samples) < LENGTH_S * RATE_HZ
            assert body[-1] > ON_THE_GROUND - 0.2
        else:
            assert episode.falls_from is None
            assert len(episode.samples) == LENGTH_S * RATE_HZ
            assert np.abs(body).max() < 0.4


def test_a_bow_is_as_deep_as_a_late_fall() -> None:
    bows = [episode.samples for episode in episodes(3, 80) if episode.kind == "bows"]
    assert max(samples[:, 0].max() for samples in bows) > 0.7
    assert all(samples[:, 2].max() > 0.4 for samples in bows)


def test_the_rate_is_that_of_the_tilt() -> None:
    for episode in episodes(5, 8):
        tilt, rate = episode.samples[:, 0], episode.samples[:, 1]
        assert np.sum(rate[:-1]) / RATE_HZ == pytest.approx(tilt[-1] - tilt[0], abs=0.2)


def test_a_window_ends_with_its_newest_sample() -> None:
    rows, falls = windows(ramp(15, falls_from=12))
    assert rows.shape == (6, WINDOW * len(CHANNELS))
    assert rows[0, 0] == 0 and rows[0, NEWEST_TILT] == 9 and rows[-1, NEWEST_TILT] == 14
    assert falls.tolist() == [False, False, False, True, True, True]


def test_windows_of_several_episodes_lie_below_each_other() -> None:
    rows, falls = all_windows([ramp(11, None), ramp(12, falls_from=10)])
    assert rows[:, NEWEST_TILT].tolist() == [9, 10, 9, 10, 11]
    assert falls.tolist() == [False, False, False, True, True]


@pytest.mark.parametrize(
    ("level", "late_s", "missed", "false"),
    [(13, (2 / RATE_HZ,), 0, 0), (11, (0.0,), 0, 0), (10, (0.0,), 0, 1), (19, (), 1, 0), (9, (0.0,), 0, 2)],
)
def test_alarms_are_late_missed_or_false(
    level: int, late_s: tuple[float, ...], missed: int, false: int
) -> None:
    some = [ramp(11, None), ramp(20, falls_from=12)]
    found = alarms(some, lambda rows: rows[:, NEWEST_TILT] > level)
    assert (found.late_s, found.missed, found.false) == (late_s, missed, false)
