"""The time for which the judge was held up is removed from a recording."""

import pytest

from workbook.criteria import without_standstills
from workbook.recording.recording import Arrival, Published, Recording, TopicRecording

PERIOD_S, LONGEST_S = 0.02, 0.1


def recording(pause_s: float) -> Recording:
    """Record a judge that publishes every 0.02 s, with a pause after 1 s.

    The program publishes before the pause, in the middle of it, and 0.5 s after it.
    """
    times = [PERIOD_S * n + (pause_s if n > 50 else 0.0) for n in range(101)]
    published = tuple(Published("/robot/imu", t, t + 3.0, {}) for t in times)
    moments = (0.5, 1.0 + pause_s / 2.0, 1.5 + pause_s)
    arrivals = tuple(Arrival(t, t + 3.0, {}, sent=t + 3.0) for t in moments)
    topic = TopicRecording("/robot/status", arrivals=arrivals, window=(0.0, 2.0 + pause_s))
    return Recording("wall", 1, topics={topic.name: topic}, published=published)


def test_a_recording_without_a_standstill_stays_as_it_is() -> None:
    seen = recording(pause_s=0.05)
    assert without_standstills(seen, PERIOD_S, LONGEST_S) == seen


def test_what_came_after_a_standstill_comes_so_much_earlier() -> None:
    seen = without_standstills(recording(pause_s=0.8), PERIOD_S, LONGEST_S)
    topic = seen.topic("/robot/status")
    assert [one.t for one in topic.arrivals] == pytest.approx([0.5, 1.0, 1.5])
    assert [one.wall for one in topic.arrivals] == pytest.approx([3.5, 4.0, 4.5])
    assert [one.published for one in topic.arrivals] == pytest.approx([3.5, 4.0, 4.5])
    assert topic.window == pytest.approx((0.0, 2.0))
    assert seen.published[-1].t == pytest.approx(2.0)
