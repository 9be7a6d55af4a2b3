"""The feedback names topics with far too many messages, and the program's other topics aren't affected."""

import pytest
from std_msgs.msg import Float32

import workbook.criteria as see
from tests.criteria.by_hand import every, on_topic, recorded
from workbook.criteria import topic

TILT = topic("/robot/tilt", Float32, hz=5.0)
BATTERY = topic("/robot/battery", Float32, hz=0.5)


def doubling(ticks: int, period: float) -> list[float]:
    return [tick * period + n * 1e-5 for tick in range(1, ticks) for n in range(2**tick)]


def one_more_each_time(ticks: int, period: float) -> list[float]:
    return [tick * period + n * 1e-5 for tick in range(1, ticks) for n in range(tick)]


@pytest.mark.parametrize(
    ("times", "cause"),
    [
        (every(0.0005, 10_000), "rate.without-a-pause"),
        ([*every(0.2, 20), *every(0.001, 2_000, 4.0)], "rate.without-a-pause"),
        (doubling(12, 0.2), "rate.grows"),
        (doubling(5, 0.2), "rate.grows"),
        (one_more_each_time(60, 0.2), "rate.grows"),
        (every(0.01, 1_399), "rate.too-fast"),
        (sorted([*every(0.2, 60), *every(0.2, 60)]), "rate.in-bursts"),
        (every(0.2, 69), ""),
    ],
    ids=["period 0", "later", "doubling", "doubling a few times", "one more", "100 Hz", "pairs", "right"],
)
def test_floods_are_told_from_other_wrong_rates(times: list[float], cause: str) -> None:
    assert see.rate(recorded(on_topic(TILT.name, times=times)), TILT).cause == cause


def test_a_right_topic_next_to_a_flood_is_right() -> None:
    recording = recorded(
        on_topic(TILT.name, times=every(0.001, 9_000)), on_topic(BATTERY.name, times=every(2.0, 7))
    )
    assert not see.rate(recording, TILT).ok
    assert see.rate(recording, BATTERY).ok
