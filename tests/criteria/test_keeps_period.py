"""A period that is almost right is detected, even if the number of messages may be off by one."""

import pytest
from std_msgs.msg import Float32

import workbook.criteria as see
from tests.criteria.by_hand import every, on_topic, recorded
from workbook.criteria import Verdict, topic

BATTERY = topic("/robot/battery", Float32, hz=0.5)


def judged(times: list[float], window: tuple[float, float] = (0.0, 8.0)) -> Verdict:
    return see.keeps_period(recorded(on_topic(BATTERY.name, times=times, window=window)), BATTERY)


@pytest.mark.parametrize(
    "times", [every(2.0, 4), [1.96, 4.05, 5.93, 8.0], every(2.15, 3), [2.0, 6.0, 8.0, 10.0, 12.0]]
)
def test_the_period_within_a_tenth_is_kept(times: list[float]) -> None:
    verdict = judged(times, (0.0, 14.0))
    assert verdict.ok
    assert verdict.saw == "one message every 2 s"


@pytest.mark.parametrize(("period", "seen"), [(2.5, "2.5 s"), (1.7, "1.7 s"), (0.5, "0.5 s")])
def test_another_period_is_told(period: float, seen: str) -> None:
    verdict = judged(every(period, 3))
    assert verdict.status == "failed"
    assert verdict.about_time
    assert seen in verdict.saw
    assert "create_timer(2.0" in verdict.try_this


def test_a_wrong_mean_is_told_although_the_typical_interval_is_right() -> None:
    times = [2.0, 4.0, 6.0, 8.0, 10.0, 12.9, 14.9, 17.8]
    verdict = see.keeps_period(
        recorded(on_topic(BATTERY.name, times=times, window=(0.0, 18.0)), clock="simulated"), BATTERY
    )
    assert verdict.saw == "on average 2.26 s from one message to the next"


def test_counts_alone_would_let_it_pass() -> None:
    """Three messages at 0.4 Hz are only one less than the four at 0.5 Hz in 8 s."""
    recording = recorded(on_topic(BATTERY.name, times=every(2.5, 3), window=(0.0, 8.0)))
    assert see.counts(recording, BATTERY).ok
    assert not see.keeps_period(recording, BATTERY).ok


def test_one_message_has_no_period() -> None:
    verdict = judged([3.0])
    assert verdict.saw == "a single message"


def test_silence_is_said_first() -> None:
    assert "no message" in judged([]).saw
