"""The judgment from two runs of a program, decided from recordings alone."""

from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import (
    Judgement,
    judge_recording,
    kept_from_simulated_time,
    with_kept_results,
)
from workbook.exercise.two_runs import (
    MOST_WALL_S,
    REAL_LIFE_S,
    STOPPED_PERIODS,
    needs_second_start,
    needs_wall_clock,
    plan_of_second_start,
    plan_on_wall_clock,
    second_start_decides,
    wall_clock_decides,
)
from workbook.recording.recording import ProcessRecord, Recording

ROOT = Path(__file__).resolve().parents[2]
EXERCISE = load_exercise("09_joint_positions", ROOT)
RIGHT = EXERCISE.source.solution_code
STATUS, JOINTS = "/robot/status", "/robot/joint_positions"
PERIOD_S = EXERCISE.periods[STATUS]
ALIVE = ProcessRecord("answer.py", watched_for=8.5)
ENDED = replace(ALIVE, exit=0, ended_at=2.0, ended_by="itself")


def seen(name: str = "solution", **changes: Any) -> Recording:
    """Load a stored recording as if its program had followed simulated time in lockstep, with some fields changed."""
    stored = Recording.load(ROOT / "tests" / "recordings" / EXERCISE.stem / f"{name}.json")
    usual: dict[str, Any] = {
        "clock": "simulated",
        "follows_clock": True,
        "following": dict.fromkeys(EXERCISE.periods, True),
        "in_lockstep": True,
        "process": ALIVE,
    }
    return replace(stored, **{**usual, **changes})


def in_real_time(recording: Recording, **changes: Any) -> Recording:
    """Return a recording as if it had been made on the wall clock."""
    usual: dict[str, Any] = {"clock": "wall", "follows_clock": None, "following": {}, "in_lockstep": False}
    return replace(recording, **{**usual, **changes})


def stretched(recording: Recording, topic: str, factor: float) -> Recording:
    """Return the recording with a topic's messages at another rate, as many as fit into the watch."""
    arrivals = [replace(one, t=one.t * factor) for one in recording.topic(topic).arrivals]
    kept = tuple(one for one in arrivals if one.t <= recording.watched_s)
    changed = replace(recording.topic(topic), arrivals=kept)
    return replace(recording, topics={**recording.topics, topic: changed})


def silent_after(recording: Recording, topic: str, count: int) -> Recording:
    """Return the recording with only the first messages of a topic."""
    changed = replace(recording.topic(topic), arrivals=recording.topic(topic).arrivals[:count])
    return replace(recording, topics={**recording.topics, topic: changed})


def judged(recording: Recording) -> Judgement:
    return judge_recording(EXERCISE, "a" * 64, recording)


def points(judgement: Judgement) -> dict[str, float]:
    return {one.id: one.points for one in judgement.criteria}


def lost(judgement: Judgement) -> set[str]:
    return {one.id for one in judgement.criteria if one.status in ("failed", "partial")}


# --- which run comes next -----------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("changes", "needed"),
    [
        ({}, False),
        ({"follows_clock": False}, True),
        ({"following": {STATUS: True}}, True),
        ({"following": dict.fromkeys(EXERCISE.periods, False)}, True),
        ({"process": replace(ENDED, watched_for=14.0)}, False),
        ({"process": ENDED, "watched_s": 2.0}, True),
        ({"process": ENDED, "topics": {}}, True),
        ({"clock": "wall", "follows_clock": False}, False),
        ({"clock": "wall", "follows_clock": False, "process": ENDED}, True),
        ({"clock": "wall", "follows_clock": None, "process": ENDED}, False),
    ],
)
def test_what_simulated_time_cannot_judge_needs_the_wall_clock(changes: dict[str, Any], needed: bool) -> None:
    assert needs_wall_clock(EXERCISE, Answer(RIGHT), judged(seen(**changes))) is needed


def test_a_lost_pace_is_final_in_lock_step_only() -> None:
    judgement = judged(seen("period_for_frequency"))
    assert lost(judgement) == {"joint_rate"}
    assert not needs_wall_clock(EXERCISE, Answer(RIGHT), judgement)
    assert needs_wall_clock(EXERCISE, Answer(RIGHT), judged(seen("period_for_frequency", in_lockstep=False)))


SPINS_ITSELF = """
class A:
    def __init__(self):
        self.create_timer(1.0, self.on_timer)

    def on_timer(self):
        rclpy.spin_once(self)
"""


@pytest.mark.parametrize("text", [f"{RIGHT}# use_sim_time", SPINS_ITSELF])
def test_a_program_that_may_pretend_needs_the_wall_clock(text: str) -> None:
    assert needs_wall_clock(EXERCISE, Answer(text), judged(seen()))


def test_neither_a_syntax_error_nor_a_crash_of_ours_needs_the_wall_clock() -> None:
    assert not needs_wall_clock(EXERCISE, Answer("def ("), judged(seen(process=ENDED, topics={})))
    ours = replace(judged(seen(follows_clock=False)), status="infra_error")
    assert not needs_wall_clock(EXERCISE, Answer(RIGHT), ours)


@pytest.mark.parametrize(
    ("changes", "needed"),
    [
        ({}, True),
        ({"clock": "wall"}, False),
        ({"process": ENDED}, False),
        ({"process": replace(ALIVE, ended_by="judge", limits_hit=("output",))}, False),
        ({"topics": {}, "nodes": ()}, False),
    ],
)
def test_only_a_living_program_with_points_is_started_again(changes: dict[str, Any], needed: bool) -> None:
    assert needs_second_start(judged(seen(**changes))) is needed


@pytest.mark.parametrize("count", [1, 10])
def test_the_wall_clock_watches_until_a_topic_that_stopped_would_stop_again(count: int) -> None:
    [first, *_] = seen().topic(STATUS).arrivals
    stopped = replace(seen().topic(STATUS), arrivals=(first,) * count)
    wall_s = plan_on_wall_clock(EXERCISE, judged(seen(topics={STATUS: stopped}))).wall_s
    assert wall_s == max(EXERCISE.plan.wall_s, (count + STOPPED_PERIODS) * PERIOD_S)
    assert (wall_s > EXERCISE.plan.wall_s) is (count == 10)


def test_the_wall_clock_watches_as_planned_where_nothing_stopped() -> None:
    assert plan_on_wall_clock(EXERCISE, None) == EXERCISE.plan
    assert plan_on_wall_clock(EXERCISE, judged(seen())).wall_s == EXERCISE.plan.wall_s


def test_the_wall_clock_does_not_watch_for_ever() -> None:
    arrivals = 3 * seen().topic(STATUS).arrivals
    many = replace(seen().topic(STATUS), arrivals=arrivals)
    recording = seen(watched_s=100.0, topics={STATUS: many})
    assert (len(arrivals) + STOPPED_PERIODS) * PERIOD_S > MOST_WALL_S
    assert plan_on_wall_clock(EXERCISE, judged(recording)).wall_s == EXERCISE.plan.wall_s


def test_a_second_start_lasts_eight_seconds_or_as_long_as_the_script() -> None:
    assert plan_of_second_start(EXERCISE, judged(seen())).wall_s == max(REAL_LIFE_S, EXERCISE.plan.wall_s)
    scripted = load_exercise("04_subscriptions_and_callbacks", ROOT)
    assert scripted.plan.script
    assert plan_of_second_start(scripted, judged(seen())).wall_s >= scripted.plan.simulated_s


# --- the judgment from both runs ----------------------------------------------------------------------------------


def test_the_wall_clock_does_not_overrule_the_pace_that_simulated_time_has_proved() -> None:
    robot = judged(seen("period_for_frequency"))
    assert lost(robot) == {"joint_rate"}
    wall = judged(in_real_time(silent_after(seen("period_for_frequency"), JOINTS, 0)))
    assert lost(wall_clock_decides(EXERCISE, None, wall)) == lost(wall) != lost(robot)
    same = judged(in_real_time(seen("period_for_frequency")))
    assert points(wall_clock_decides(EXERCISE, robot, same)) == points(robot)


def test_the_recording_names_the_results_that_another_recording_showed() -> None:
    """So the same criteria, which see only this recording, can't silently change the points."""
    robot = judged(seen())
    joints = in_real_time(seen()).topic(JOINTS)
    with_a_gap = replace(joints, arrivals=joints.arrivals[:5] + joints.arrivals[6:])
    wall = in_real_time(seen())
    wall = replace(wall, topics={**wall.topics, JOINTS: with_a_gap})
    decided = wall_clock_decides(EXERCISE, robot, judged(wall))
    assert decided.full_marks and lost(judged(wall)) == {"joint_rate"}
    assert decided.recording is not None
    assert kept_from_simulated_time(decided.recording) == {"joint_rate"}
    again = judged(decided.recording)
    assert lost(again) == {"joint_rate"}
    assert with_kept_results(decided, again).criteria == decided.criteria
    alike = wall_clock_decides(EXERCISE, robot, judged(in_real_time(seen())))
    assert alike.recording is not None and not kept_from_simulated_time(alike.recording)


def test_another_rate_in_real_time_overrules_simulated_time() -> None:
    real = in_real_time(stretched(seen(), STATUS, 3.0))
    decided = wall_clock_decides(EXERCISE, judged(seen()), judged(real))
    assert lost(decided) == lost(judged(real)) == {"status_kept"}


def test_clocks_that_contradict_each_other_leave_a_doubt_unless_simulated_time_proves_nothing() -> None:
    unproved = judged(seen(following=dict.fromkeys(EXERCISE.periods, True), in_lockstep=False))
    late = judged(in_real_time(seen("period_for_frequency"), nodes=seen().nodes))
    assert "passed on robot time" in wall_clock_decides(EXERCISE, unproved, late).inconclusive_reason
    assert wall_clock_decides(EXERCISE, None, late).inconclusive_reason == ""


@pytest.mark.parametrize(
    ("real", "clock", "expected"),
    [
        (in_real_time(seen()), "simulated", set()),
        (in_real_time(seen(), process=replace(ENDED, ended_at=6.0)), "simulated", {"alive_at_end"}),
        (in_real_time(seen(), watched_s=0.4, process=ENDED), "wall", {"alive_at_end"}),
        (in_real_time(stretched(seen(), STATUS, 3.0)), "wall", {"status_kept"}),
        (in_real_time(seen("eleven_values")), "wall", {"twelve_values"}),
    ],
    ids=["as before", "it ends later", "it ends early", "another rate", "other values"],
)
def test_a_second_start_decides_if_it_contradicts_the_first(
    real: Recording, clock: str, expected: set[str]
) -> None:
    decided = second_start_decides(EXERCISE, judged(seen()), judged(real))
    assert decided.recording is not None
    assert (decided.recording.clock, lost(decided)) == (clock, expected)
