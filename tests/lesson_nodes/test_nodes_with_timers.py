"""The nodes of lesson 05: each timer keeps its own period, and an invalid period is refused."""

import math

import pytest

from lesson_nodes import blink_and_beep, two_arms
from tests.lesson_nodes.ending import ended_well
from workbook.lesson import arrivals, record, start, values

BLINK, BEEP, JOINTS = "/robot/blink", "/robot/beep", "/robot/joint_positions"


def test_a_minute_has_sixty_blinks_and_thirty_beeps() -> None:
    recording = record(blink_and_beep, {BLINK: 1.0, BEEP: 2.0}, seconds=60)
    assert [round(t) for t in arrivals(recording, BLINK)] == list(range(1, 61))
    assert [round(t) for t in arrivals(recording, BEEP)] == list(range(2, 61, 2))


@pytest.mark.whole
def test_a_long_beep_silences_the_blinks() -> None:
    recording = record(
        blink_and_beep, {BLINK: 0.2, BEEP: 2.0}, clock="wall", blink_period_s=0.2, beep_takes_s=1.1
    )
    blinks, beeps = arrivals(recording, BLINK), arrivals(recording, BEEP)
    assert len(beeps) >= 4
    for beep in beeps[:3]:
        assert not [t for t in blinks if beep + 0.1 < t < beep + 1.0]


def test_each_arm_moves_to_its_own_timer() -> None:
    recording = record(two_arms, {JOINTS: 0.1}, seconds=7, left_period_s=0.1, right_period_s=1.0)
    poses = values(recording, JOINTS)
    left = [pose[two_arms.LEFT_SHOULDER] for pose in poses]
    right = [pose[two_arms.RIGHT_SHOULDER] for pose in poses]
    assert len(set(left)) > 25  # moving up and moving down, it passes through the same angles
    assert 4 <= len(set(right)) <= 8
    assert ended_well(recording), recording.process
    assert all(len(pose) == two_arms.JOINT_COUNT for pose in poses)
    assert all(math.isfinite(angle) for pose in poses for angle in pose)


@pytest.mark.parametrize(
    ("program", "parameters", "words"),
    [
        (two_arms, {"left_period_s": 0.0}, "not 0.0"),
        (two_arms, {"right_period_s": -1.0}, "not -1.0"),
        (blink_and_beep, {"blink_period_s": 0.0}, "not 0.0"),
        (blink_and_beep, {"beep_takes_s": -0.5}, "not -0.5"),
    ],
)
def test_impossible_times_are_refused_in_words(
    program: object, parameters: dict[str, float], words: str
) -> None:
    with pytest.raises(RuntimeError, match=words):
        start(program, **parameters)  # type: ignore[arg-type]
