"""Combine the results of two runs of one program: one in simulated time, and one in real time.

A run is represented by its judgment, which contains the recording. `on_simulated` is the judgment from simulated time,
and `on_wall` is the judgment from the wall clock.
"""

from dataclasses import replace
from statistics import median

from workbook.criteria.runner import CriterionResult
from workbook.exercise.answers import Answer, syntax_mistake
from workbook.exercise.definition import Exercise
from workbook.exercise.inconclusive import find_inconclusive_reason
from workbook.exercise.judgement import KEPT, Judgement, judge_recording
from workbook.exercise.spins import spins_in_a_callback
from workbook.recording.plan import Plan
from workbook.recording.recording import Recording
from workbook.watching.following import intervals_of, rates_differ
from workbook.watching.parameter_services import USE_SIM_TIME

REAL_LIFE_S = 8.0
ENDS_EARLY_S = 1.5
"""A program that exits this soon (s) in real time hasn't shown how it behaves there."""
WORKED_PERIODS = 3
"""How long a program must run in simulated time before its exit counts, in longest judged periods.

A program that exits earlier also exits while it's watched on the wall clock.
"""
STOPPED_PERIODS = 2.5
"""A topic that is silent for this many of its periods has stopped."""
MOST_WALL_S = 26.0
"""The most time (s) to watch on the wall clock for a topic to stop: twenty seconds of messages, then the silence."""


# --- which run comes next -----------------------------------------------------------------------------------------


def is_distrusted(answer: Answer) -> bool:
    """Return whether simulated time can't prove anything: the program spins in a callback or sets its own clock."""
    return USE_SIM_TIME in answer.text or spins_in_a_callback(answer.text)


def needs_wall_clock(exercise: Exercise, answer: Answer, judgement: Judgement) -> bool:
    """Return whether a program that should be judged in simulated time must be judged on the wall clock."""
    recording = judgement.recording
    if is_distrusted(answer):
        return True
    if recording is None or judgement.status != "graded":
        return False
    if recording.clock == "wall":  # a request to switch to simulated time may crash a program
        return recording.process.ended_by == "itself" and recording.follows_clock is False
    if recording.process.ended_by == "itself":
        return syntax_mistake(answer.text) is None and not _ended_for_good(exercise, recording)
    if not recording.follows_clock or _is_any_undecided(exercise, recording):
        return True
    return any(result.about_time and not _is_final(recording, result) for result in judgement.criteria)


def needs_second_start(judgement: Judgement) -> bool:
    """Return whether a program that was judged in simulated time could still behave differently in real time."""
    recording = judgement.recording
    if not judgement.score or recording is None or recording.clock != "simulated":
        return False
    return recording.process.ended_by != "itself" and not recording.process.limits_hit


def plan_on_wall_clock(exercise: Exercise, on_simulated: Judgement | None) -> Plan:
    """Return the plan for the wall clock: long enough to repeat the messages of a topic that stopped in simulated time.

    A topic with few messages doesn't prove that it follows simulated time.
    """
    plan, seen = exercise.plan, on_simulated.recording if on_simulated is not None else None
    if seen is None:
        return plan
    needed = [plan.wall_s]
    for name, period in exercise.periods.items():
        arrivals = seen.topic(name).arrivals
        if arrivals and seen.watched_s - arrivals[-1].t > STOPPED_PERIODS * period:
            needed.append((len(arrivals) + STOPPED_PERIODS) * period)
    return replace(plan, wall_seconds=max(one for one in needed if one <= max(MOST_WALL_S, plan.wall_s)))


def plan_of_second_start(exercise: Exercise, on_simulated: Judgement) -> Plan:
    """Return the plan for the second start of a program judged in simulated time. The script is played to the end."""
    plan = plan_on_wall_clock(exercise, on_simulated)
    script_s = plan.simulated_s if plan.script else 0.0
    return replace(plan, wall_seconds=max(REAL_LIFE_S, plan.wall_s, script_s))


# --- their combined meaning ---------------------------------------------------------------------------------------


def with_inconclusive_reason(
    exercise: Exercise, judgement: Judgement, on_simulated: Judgement | None = None
) -> Judgement:
    """Return the judgment with the reason, if any, why it's inconclusive.

    `on_simulated`: the same program's judgment in simulated time.
    """
    recording = judgement.recording
    if judgement.status != "graded" or recording is None:
        return judgement
    before: tuple[CriterionResult, ...] = ()
    if (
        on_simulated is not None
        and on_simulated.recording is not None
        and on_simulated.recording.follows_clock
    ):
        if not _is_any_undecided(exercise, on_simulated.recording):
            before = on_simulated.criteria
    inconclusive_reason = find_inconclusive_reason(
        judgement.criteria, recording, exercise.plan, exercise.periods, before
    )
    return replace(
        judgement, inconclusive_reason=inconclusive_reason.reason, end_only=inconclusive_reason.end_only
    )


def wall_clock_decides(exercise: Exercise, on_simulated: Judgement | None, on_wall: Judgement) -> Judgement:
    """Return the judgment on the wall clock, with simulated time's results for the pace of topics that follow it.

    A shorter watch in real time doesn't overrule the many messages in simulated time, unless it shows another rate.
    `on_simulated`: None if there was no such run, or if it doesn't prove anything.
    """
    if on_simulated is not None:
        on_wall = _with_what_simulated_time_proved(on_simulated, on_wall)
    return with_inconclusive_reason(exercise, on_wall, on_simulated)


def second_start_decides(exercise: Exercise, on_simulated: Judgement, on_wall: Judgement) -> Judgement:
    """Return the judgment in real time if it contradicts the one in simulated time, or else the latter.

    Along with the latter, the first process's exit counts, because the judge interrupted that process as planned. But
    if the second process exited by itself or hit a limit, the second exit counts.
    """
    if on_wall.status != "graded" or _contradicts(exercise, on_simulated, on_wall):
        return with_inconclusive_reason(exercise, on_wall)
    simulated, real = _recordings(on_simulated, on_wall)
    ended = real.process.ended_by == "itself" or real.process.limits_hit
    process = real.process if ended else replace(simulated.process, watched_for=real.process.watched_for)
    both = replace(simulated, process=process)
    return with_inconclusive_reason(
        exercise, judge_recording(exercise, on_simulated.answer_sha256, both, real_life=True)
    )


def _with_what_simulated_time_proved(on_simulated: Judgement, on_wall: Judgement) -> Judgement:
    recording, real = on_simulated.recording, on_wall.recording
    if recording is None or real is None or on_wall.status != "graded":
        return on_wall
    before = {result.id: result for result in on_simulated.criteria}

    def of_both(result: CriterionResult) -> CriterionResult:
        earlier = before.get(result.id, result)
        proved = [one.pace_of for one in (result, earlier) if _is_final(recording, one)]
        kept = proved and not any(_has_another_rate(recording, real, topic) for topic in proved)
        return earlier if kept else result

    criteria = tuple(map(of_both, on_wall.criteria))
    kept = [
        one.id
        for one, other in zip(criteria, on_wall.criteria, strict=True)
        if (one.status, one.points) != (other.status, other.points)
    ]
    notes = (*real.notes, KEPT + " ".join(kept)) if kept else real.notes
    return replace(on_wall, criteria=criteria, recording=replace(real, notes=notes))


def _contradicts(exercise: Exercise, on_simulated: Judgement, on_wall: Judgement) -> bool:
    """Return whether a program behaved differently in real time, after a second start, than in simulated time.

    With a script, every judged result must be unchanged. Without a script, the watch in real time is too short to judge
    the rates again, so they're only compared. The way in which the program exited doesn't matter, unless it exited too
    early.
    """
    simulated, real = _recordings(on_simulated, on_wall)
    if real.process.ended_by == "itself" and real.watched_s < ENDS_EARLY_S:
        return True
    scripted = bool(exercise.plan.script)
    if not scripted and any(_has_another_rate(simulated, real, topic) for topic in exercise.periods):
        return True
    before = {result.id: result.status for result in on_simulated.criteria}
    alive = replace(real, process=simulated.process)
    return any(
        result.status in ("failed", "partial") and before[result.id] == "passed"
        for result in judge_recording(exercise, on_simulated.answer_sha256, alive, real_life=True).criteria
        if not result.about_end and (scripted or not result.about_time)
    )


def _recordings(on_simulated: Judgement, on_wall: Judgement) -> tuple[Recording, Recording]:
    assert on_simulated.recording is not None and on_wall.recording is not None
    return on_simulated.recording, on_wall.recording


def _ended_for_good(exercise: Exercise, recording: Recording) -> bool:
    """Return whether a program that exited in simulated time had already run long enough for its exit to count.

    If the program exited earlier, a run on the wall clock shows that as well.
    """
    published = any(recording.topic(name).arrivals for name in exercise.periods)
    return published and recording.watched_s >= WORKED_PERIODS * exercise.plan.longest_period


def _is_any_undecided(exercise: Exercise, recording: Recording) -> bool:
    """Return whether a topic has messages that aren't proven to follow simulated time."""
    return any(
        recording.topic(name).arrivals and not recording.following.get(name, False)
        for name in exercise.periods
    )


def _is_final(recording: Recording, result: CriterionResult) -> bool:
    """Return whether simulated time decides this result, which must be about the pace of a topic that follows it.

    If simulated time runs at a fixed pace, not in lockstep, even a brief sleep in a callback causes a long delay in it.
    So a result about time is final only in lockstep. But if one topic stops while others go on, a short delay can't be
    the reason, so that result is final, too.
    """
    return (recording.in_lockstep or not result.about_time) and recording.following.get(result.pace_of, False)


def _has_another_rate(simulated: Recording, real: Recording, topic: str) -> bool:
    """Return whether a topic that had messages in simulated time has a different rate in real time."""
    seen = intervals_of(simulated, topic)
    return bool(seen) and rates_differ(median(seen), real, topic)
