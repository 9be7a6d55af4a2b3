from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.pictures.reading import colored, drawn, reddish
from workbook.pictures import palette, png, timeline
from workbook.pictures.marks import gaps, tiny
from workbook.recording.recording import (
    Arrival,
    ProcessRecord,
    PublisherSeen,
    Recording,
    Stretch,
    TopicRecording,
)

JOINTS, STATUS = "/robot/joint_positions", "/robot/status"


def recording(
    times: Mapping[str, Sequence[float]],
    *,
    process: ProcessRecord | None = None,
    speed: float = 10.0,
    window: tuple[float, float] = (0.0, 20.0),
) -> Recording:
    seen = PublisherSeen("/robot/humanoid", "std_msgs/msg/String", "reliable", "volatile", 0.0)
    topics = {
        name: TopicRecording(name, (seen,), (), tuple(Arrival(t, 0.5 + t / speed, {}) for t in at), window)
        for name, at in times.items()
    }
    return Recording(
        "simulated", 7, (Stretch(speed, 0.0, 20.0),), 20.0, 2.5, topics, (), process or ProcessRecord()
    )


def shaded(picture: bytes, row: int = 0) -> list[tuple[int, int]]:
    """Return the first and last column (dots) of each shaded stretch of a row."""
    columns = reddish(picture)[int(24 + 80 * row) : int(84 + 80 * row)].any(axis=0).astype(int)
    steps = np.diff(np.concatenate(([0], columns, [0])))
    starts, ends = np.nonzero(steps == 1)[0], np.nonzero(steps == -1)[0]
    return [(int(a), int(b)) for a, b in zip(starts, ends, strict=True) if b - a > 12]


def test_a_gap_is_shaded_where_it_is() -> None:
    steady = timeline.timeline(recording({JOINTS: range(2, 21, 2)}), periods={JOINTS: 2.0})
    broken = timeline.timeline(recording({JOINTS: [2, 4, 6, 12, 14, 16, 18, 20]}), periods={JOINTS: 2.0})
    assert shaded(steady) == []
    (gap,) = shaded(broken)
    blue = np.nonzero(colored(broken, palette.BLUE)[24:84].any(axis=0))[0]
    before, after = blue[blue < gap[0]].max(), blue[blue > gap[1]].min()
    assert 0 < gap[0] - before < 16
    assert 0 < after - gap[1] < 16


def test_no_line_strikes_out_the_words_of_a_gap() -> None:
    picture = timeline.timeline(recording({JOINTS: [2, 4, 6, 12, 14, 16, 18, 20]}), periods={JOINTS: 2.0})
    (gap,) = shaded(picture)
    line = drawn(picture)[64, gap[0] + 8 : gap[1] - 8].astype(int)
    assert line[0] and line[-1], "the line is there at both ends of the gap"
    begins, ends = np.nonzero(np.diff(line) == -1)[0], np.nonzero(np.diff(line) == 1)[0]
    room = ends - begins
    assert min(room[0], room[-1]) >= 6, "between the line and the words there is room on both sides"


def test_silence_before_the_first_and_after_the_last_message_is_a_gap() -> None:
    picture = timeline.timeline(recording({JOINTS: [8, 10, 12]}), periods={JOINTS: 2.0})
    assert len(shaded(picture)) == 2


def test_nothing_is_missing_outside_the_window_of_a_topic() -> None:
    late = recording({JOINTS: [12, 14, 16, 18, 20]}, window=(11.0, 20.0))
    assert shaded(timeline.timeline(late, periods={JOINTS: 2.0})) == []


def test_without_a_period_nothing_is_called_a_gap() -> None:
    assert shaded(timeline.timeline(recording({JOINTS: [2, 18]}))) == []


def marks(picture: bytes, row: int, color: str) -> int:
    columns = colored(picture, color)[int(24 + 80 * row) : int(84 + 80 * row)].any(axis=0).astype(int)
    return int(np.count_nonzero(np.diff(np.concatenate(([0], columns))) == 1))


def test_there_is_a_mark_per_arrival() -> None:
    picture = timeline.timeline(
        recording({JOINTS: range(2, 21, 2), STATUS: range(1, 16)}), topics=[JOINTS, STATUS]
    )
    assert marks(picture, 0, palette.BLUE) == 10
    assert marks(picture, 1, palette.BLUE) == 15


def test_marks_are_blue_as_data_unless_a_row_has_another_color() -> None:
    rows = [timeline.Row("as data", [1.0, 2.0]), timeline.Row("alarm", [1.5], color=palette.AMBER)]
    picture = timeline.draw(rows, end=3.0)
    assert (marks(picture, 0, palette.BLUE), marks(picture, 1, palette.AMBER)) == (2, 1)


def test_expected_ticks_are_added_for_a_period() -> None:
    times = {"timer": [1.0, 2.0, 3.0]}
    plain = timeline.strip(times, end=4.0)
    asked = timeline.strip(times, periods={"timer": 0.5}, end=4.0)
    band = slice(20, 34)
    extra = np.count_nonzero(colored(asked, palette.GREY, 90)[band].any(axis=0))
    assert extra > np.count_nonzero(colored(plain, palette.GREY, 90)[band].any(axis=0))


def test_a_topic_that_was_asked_for_and_never_came_has_its_row() -> None:
    one = timeline.timeline(recording({STATUS: [1.0]}))
    both = timeline.timeline(recording({STATUS: [1.0]}), periods={JOINTS: 2.0})
    assert png.size(both)[1] - png.size(one)[1] == 80
    assert shaded(both, 0), "a silent topic is one long gap"


def test_the_clock_and_the_log_are_not_drawn_unasked() -> None:
    noisy = recording({STATUS: [1.0], "/rosout": [1.0], "/parameter_events": [1.0], "/clock": [1.0]})
    assert png.size(timeline.timeline(noisy))[1] == png.size(timeline.timeline(recording({STATUS: [1.0]})))[1]


def test_the_end_of_the_program_is_marked_in_simulated_time() -> None:
    died = ProcessRecord(exit=1, ended_at=0.5 + 1.25, ended_by="itself")
    record = recording({STATUS: range(1, 12)}, process=died)
    assert timeline.process_end(record) == pytest.approx(12.5)
    picture = timeline.timeline(record)
    line = np.nonzero(colored(picture, palette.RED)[10:80].all(axis=0))[0]
    assert len(line) > 0
    blue = np.nonzero(colored(picture, palette.BLUE)[24:84].any(axis=0))[0]
    assert line.min() > blue.max()


@pytest.mark.parametrize(
    "process", [ProcessRecord(), ProcessRecord(signal="SIGINT", ended_at=2.4, ended_by="judge")]
)
def test_a_program_that_lived_to_the_end_has_no_mark(process: ProcessRecord) -> None:
    record = recording({STATUS: range(1, 20)}, process=process)
    assert timeline.process_end(record) is None
    assert np.count_nonzero(colored(timeline.timeline(record), palette.RED)) == 0


def test_a_program_that_published_nothing_can_be_drawn() -> None:
    record = Recording(
        "wall", 3, watched_s=5.0, wall_s=5.0, process=ProcessRecord(exit=1, ended_at=0.4, ended_by="itself")
    )
    assert np.count_nonzero(colored(timeline.timeline(record), palette.RED)) > 0
    assert timeline.describe(record) == "timeline of messages: nothing was published; the program ended early"


def test_the_description_names_topics_rates_and_gaps() -> None:
    record = recording({JOINTS: [2, 4, 12, 14, 16, 18, 20], STATUS: range(1, 21)})
    words = timeline.describe(record, {JOINTS: 2.0, STATUS: 1.0, "/robot/battery": 2.0})
    assert words == (
        "timeline of messages: /robot/joint_positions at 0.33 Hz (0.5 Hz due), with gaps; "
        "/robot/status at 1 Hz as due, without a gap; /robot/battery silent"
    )


def test_the_description_of_a_wrong_rate_says_both_rates() -> None:
    fast = recording({JOINTS: [number / 99 for number in range(20 * 99)]})
    assert "at 99 Hz (0.5 Hz due), without a gap" in timeline.describe(fast, {JOINTS: 2.0})
    once = recording({JOINTS: [3.0]})
    assert "once (0.5 Hz due), with gaps" in timeline.describe(once, {JOINTS: 2.0})


def test_a_rate_at_the_steps_of_simulated_time_may_be_higher() -> None:
    fast = replace(recording({JOINTS: [0.1 * n for n in range(140)]}), step_s=0.1)
    assert "at ≥ 10 Hz (0.5 Hz due)" in timeline.describe(fast, {JOINTS: 2.0})
    without = replace(fast, step_s=None)
    assert "at 10 Hz (0.5 Hz due)" in timeline.describe(without, {JOINTS: 2.0})
    assert timeline.timeline(fast) != timeline.timeline(without)


def test_the_description_of_a_rate_that_is_as_due_is_the_same_in_every_run() -> None:
    told = {
        timeline.describe(recording({JOINTS: [shift + 2.01 * k for k in range(10)]}), {JOINTS: 2.0})
        for shift in (0.0, 0.1)
    }
    assert told == {"timeline of messages: /robot/joint_positions at 0.5 Hz as due, without a gap"}


@given(st.lists(st.floats(0, 100), max_size=30), st.floats(0.1, 20))
def test_gaps_are_exactly_the_stretches_without_a_mark(times: list[float], period: float) -> None:
    found = gaps(times, period, 0.0, 100.0)
    assert all(b - a > 1.5 * period for a, b in found)
    assert not any(a < t < b for t in times for a, b in found)
    edges = sorted([0.0, 100.0, *times])
    assert len(found) == sum(b - a > 1.5 * period + 1e-9 for a, b in pairwise(edges))


def test_the_tiny_timeline_shows_marks_and_gaps() -> None:
    steady = tiny([2, 4, 6, 8], end=10, period=2)
    broken = tiny([2, 8], end=10, period=2)
    assert png.size_on_screen(steady) == (240, 18)
    assert np.count_nonzero(reddish(steady)) == 0
    red = np.nonzero(reddish(broken).any(axis=0))[0]
    assert 0.2 < red.min() / 480 < red.max() / 480 < 0.82
    columns = colored(steady, palette.BLUE).any(axis=0).astype(int)
    assert np.count_nonzero(np.diff(columns) == 1) == 4


def test_tiny_is_small_enough_for_a_card() -> None:
    assert len(png.data_uri(tiny(range(60), end=60, period=1))) < 2500


def test_a_histogram_is_as_high_as_its_values_are_many() -> None:
    picture = timeline.histogram([10.0] * 30 + [20.0] * 10, bins=2)
    blue = colored(picture, palette.BLUE)
    left, right = (np.count_nonzero(half.any(axis=1)) for half in np.hsplit(blue, 2))
    assert right / left == pytest.approx(1 / 3, abs=0.03)


def test_a_histogram_marks_its_target() -> None:
    values = [9.0, 10.0, 11.0]
    amber = colored(timeline.histogram(values, target=10.0), palette.AMBER)
    assert np.count_nonzero(amber) > 100
    assert np.count_nonzero(colored(timeline.histogram(values), palette.AMBER)) == 0


def test_a_histogram_of_one_repeated_value_and_of_none() -> None:
    assert np.count_nonzero(colored(timeline.histogram([5.0] * 9), palette.BLUE)) > 500
    with pytest.raises(ValueError, match="at least one finite value"):
        timeline.histogram([float("nan")])


@pytest.mark.parametrize("times", [[], [0.0], [1e-9, 2e-9], [1e6], [float(i) / 100 for i in range(3000)]])
def test_any_times_can_be_drawn(times: list[float]) -> None:
    assert png.size(timeline.strip({"timer": times}, periods={"timer": 0.01}))[0] == 2 * timeline.WIDTH
