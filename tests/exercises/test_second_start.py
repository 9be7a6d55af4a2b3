"""Judge a program by two processes: one on simulated time, and a second one in real time."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any
from unittest.mock import patch

import pytest

from workbook.exercise import judging
from workbook.exercise.answers import Answer
from workbook.exercise.definition import load_exercise
from workbook.exercise.judgement import Judgement
from workbook.exercise.judging import Judge
from workbook.recording.plan import Plan
from workbook.recording.recording import Arrival, ProcessRecord, Recording

ROOT = Path(__file__).resolve().parents[2]
EXERCISE = load_exercise("09_joint_positions", ROOT)
REAL_S = 8.5
ALIVE = ProcessRecord("answer.py", None, None, None, None, REAL_S)


def in_simulated_time() -> Recording:
    """Load the stored recording of a right answer on simulated time."""
    recording = Recording.load(ROOT / "tests" / "recordings" / EXERCISE.stem / "solution.json")
    following = dict.fromkeys(EXERCISE.periods, True)
    return replace(recording, following=following, in_lockstep=True, process=ALIVE)


def in_real_time(process: ProcessRecord = ALIVE, lasts_s: float = REAL_S, **changes: Any) -> Recording:
    """Return a recording of the same program in real time that lasts `lasts_s` seconds."""
    recording = in_simulated_time()

    def came(arrivals: tuple[Arrival, ...]) -> tuple[Arrival, ...]:
        return tuple(one for one in arrivals if one.t <= lasts_s)

    topics = {
        name: replace(topic, arrivals=came(topic.arrivals), window=(0.0, lasts_s))
        for name, topic in recording.topics.items()
    }
    real = replace(
        recording,
        clock="wall",
        stretches=(),
        follows_clock=None,
        following={},
        in_lockstep=False,
        step_s=None,
    )
    return replace(real, watched_s=lasts_s, topics=topics, process=process, **changes)


def silent(recording: Recording, topic: str) -> Recording:
    """Remove a topic's messages from the recording."""
    return replace(
        recording, topics={**recording.topics, topic: replace(recording.topic(topic), arrivals=())}
    )


def ended(at_s: float) -> ProcessRecord:
    """Return a process that has ended by itself."""
    return ProcessRecord("answer.py", 0, None, at_s, "itself", at_s)


@dataclass
class StandIn:
    """Replaces the observer and the watches on it: each watch returns the next recording."""

    recordings: list[Recording]
    plans: list[Plan] = field(default_factory=list)

    def keep_off(self, domains: object) -> None:
        pass

    def watch(
        self, observer: object, spec: object, plan: Plan, clock: str, process: object = None
    ) -> "StandIn":
        assert clock == self.recordings[0].clock
        self.plans.append(plan)
        return self

    def observe(self, cancel_soak: Callable[[], bool]) -> Recording:
        return self.recordings.pop(0)

    def keep_watching(self, wall_s_after_match: float, cancel_soak: Callable[[], bool]) -> bool:
        return not cancel_soak()

    def with_its_nodes(self, recording: Recording) -> Recording:
        return recording

    def finish(self, recording: Recording) -> Recording:
        process = recording.process
        if process.ended_by is None:
            process = replace(process, exit=0, ended_by="judge")
        return replace(recording, process=process)

    def __enter__(self) -> "StandIn":
        return self

    def __exit__(self, *_: object) -> None:
        pass


def judged(
    *recordings: Recording, soak: bool = True, cancel_soak: bool = False, wall_s: float = 8.0
) -> Judgement:
    """Judge a program that has these recordings, and check that all are used.

    `wall_s`: the second watch's length (s).
    """
    observer: Any = StandIn([*recordings])
    answer = Answer(EXERCISE.source.solution_code)
    with patch.object(judging, "Watch", observer.watch):
        judgement = Judge(observer).judge(EXERCISE, answer, soak=soak, cancel_soak=lambda: cancel_soak)
    assert not observer.recordings
    assert len(observer.plans) == 1 or observer.plans[1].wall_s >= wall_s
    return judgement


def lost(judgement: Judgement) -> set[str]:
    return {one.id for one in judgement.criteria if one.status in ("failed", "partial")}


def recording_of(judgement: Judgement) -> Recording:
    assert judgement.recording is not None
    return judgement.recording


def test_a_program_that_is_as_it_was_keeps_what_simulated_time_has_seen_and_its_first_end() -> None:
    judgement = judged(in_simulated_time(), in_real_time())
    assert judgement.full_marks and judgement.watched_real_life
    recording = recording_of(judgement)
    assert recording.clock == "simulated"
    assert (recording.process.ended_by, recording.process.watched_for) == ("judge", REAL_S)


def test_an_end_by_itself_in_real_time_counts() -> None:
    judgement = judged(in_simulated_time(), in_real_time(ended(6.0), 6.0))
    assert lost(judgement) == {"alive_at_end"}
    assert recording_of(judgement).process == ended(6.0)


def test_a_program_that_ends_early_in_real_time_is_judged_by_that() -> None:
    judgement = judged(in_simulated_time(), in_real_time(ended(0.4), 0.4))
    assert recording_of(judgement).clock == "wall"
    assert (lost(judgement), judgement.score) == ({"program_runs"}, 0.0)


def test_an_end_hides_nothing_else_of_real_time() -> None:
    real = silent(in_real_time(ended(6.0), 6.0), "/robot/status")
    judgement = judged(in_simulated_time(), real)
    assert recording_of(judgement).clock == "wall"
    assert {"status_kept", "alive_at_end"} <= lost(judgement)


@pytest.mark.parametrize("delay_s", [0.0, 1.0])
def test_a_disturbed_second_start_never_counts(delay_s: float) -> None:
    real = silent(in_real_time(held_up_s=delay_s), "/robot/status")
    judgement = judged(in_simulated_time(), real)
    assert lost(judgement) == {"status_kept"}
    assert judgement.watched_real_life
    assert judgement.is_inconclusive is (delay_s > 0.0)


def test_when_it_is_enough_simulated_time_alone_counts() -> None:
    judgement = judged(in_simulated_time(), in_real_time(lasts_s=0.2), cancel_soak=True)
    assert judgement.full_marks
    assert not judgement.watched_real_life


def test_a_program_is_started_once_where_nobody_wants_its_real_seconds_or_it_has_no_points() -> None:
    assert judged(in_simulated_time(), soak=False).full_marks
    ends_at_once = replace(in_simulated_time(), process=ended(2.0))
    assert "alive_at_end" in lost(judged(ends_at_once))


@pytest.mark.parametrize("soak", [False, True])
def test_what_simulated_time_cannot_judge_goes_on_to_the_wall_clock(soak: bool) -> None:
    undecided = replace(in_simulated_time(), following={})
    judgement = judged(undecided, in_real_time(), soak=soak, wall_s=EXERCISE.plan.wall_s)
    assert recording_of(judgement).clock == "wall"
    assert judgement.watched_real_life
