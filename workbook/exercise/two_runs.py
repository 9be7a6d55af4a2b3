"""What two runs of one program mean together: one on simulated time, and one in real time. Runs nothing itself.

A run is given as its judgement, which holds its recording. `on_simulated` is the one on simulated time.
"""

from dataclasses import replace
from statistics import median

from workbook.criteria.runner import CriterionResult
from workbook.exercise.answers import Answer, syntax_mistake
from workbook.exercise.definition import Exercise
from workbook.exercise.inconclusive import find_inconclusive_reason
from workbook.exercise.judgement import Judgement, judge_recording
from workbook.exercise.spins import spins_in_a_callback
from workbook.recording.plan import Plan
from workbook.recording.recording import Recording
from workbook.watching.following import intervals_of, rates_differ
from workbook.watching.parameter_services import USE_SIM_TIME

REAL_LIFE_S = 8.0
ENDS_EARLY_S = 1.5
"""A program that ends so soon (s) in real time has not shown what it does there."""
WORKED_PERIODS = 3
"""Of simulated time, the longest judged period: so long the wall clock watches in any case."""
STOPPED_PERIODS = 2.5
"""A topic that is silent for so many of its periods has stopped."""
MOST_WALL_S = 26.0
"""The wall clock watches at most so long (s) for a topic to stop: twenty seconds of messages, and the silence after."""


# --- which run comes next -----------------------------------------------------------------------------------------


def is_distrusted(answer: Answer) -> bool:
    """Whether simulated time proves nothing of a program: a callback spins, or it sets its own clock."""
    return USE_SIM_TIME in answer.text or spins_in_a_callback(answer.text)


def needs_wall_clock(exercise: Exercise, answer: Answer, judgement: Judgement) -> bool:
    """Whether a program that was to be judged on simulated time has to be judged on the wall clock."""
    recording = judgement.recording
    if is_distrusted(answer):
        return True
    if recording is None or judgement.status != "graded":
        return False
    if recording.clock == "wall":  # to be asked whether it can be switched may end a program
        return recording.process.ended_by == "itself" and recording.follows_clock is False
    if recording.process.ended_by == "itself":
        return syntax_mistake(answer.text) is None and not _ended_for_good(exercise, recording)
    if not recording.follows_clock or _is_any_undecided(exercise, recording):
        return True
    return any(result.about_time and not _is_final(recording, result) for result in judgement.criteria)


def needs_second_start(judgement: Judgement) -> bool:
    """Whether a program that simulated time has judged can show in real time that it is otherwise there."""
    recording = judgement.recording
    if not judgement.score or recording is None or recording.clock != "simulated":
        return False
    return recording.process.ended_by != "itself" and not recording.process.limits_hit


def plan_on_wall_clock(exercise: Exercise, on_simulated: Judgement | None) -> Plan:
    """The plan for the wall clock: long enough for a topic to stop there, too, if it did so on simulated time.

    A topic that brings few messages does not prove that it follows simulated time.
    """
    plan, seen = exercise.plan, on_simulated.recording if on_simulated is not None else None
    if seen is None:
        return plan
    needed = [plan.wall_s]
    for name, period in exercise.periods.items():
        arrivals = seen.topic(name).arrivals
        if arrivals and seen.simulated_s - arrivals[-1].t > STOPPED_PERIODS * period:
            needed.append((len(arrivals) + STOPPED_PERIODS) * period)
    return replace(plan, wall_seconds=max(one for one in needed if one <= max(MOST_WALL_S, plan.wall_s)))


def plan_of_second_start(exercise: Exercise, on_simulated: Judgement) -> Plan:
    """The plan for a program that was judged on simulated time; its script is played to the end."""
    plan = plan_on_wall_clock(exercise, on_simulated)
    script_s = plan.simulated_s if plan.script else 0.0
    return replace(plan, wall_seconds=max(REAL_LIFE_S, plan.wall_s, script_s))


# --- what they mean together --------------------------------------------------------------------------------------


def with_doubt(exercise: Exercise, judgement: Judgement, on_simulated: Judgement | None = None) -> Judgement:
    """The judgement, and whether it is conclusive. `on_simulated`: what simulated time had said of the same program."""
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
    """The judgement of the wall clock, but for the pace of topics that follow simulated time.

    A shorter watch in real time does not overrule what many messages of simulated time have shown, unless it shows
    another rate. `on_simulated`: None if there was no such run, or it proves nothing.
    """
    if on_simulated is not None:
        on_wall = _with_what_simulated_time_proved(on_simulated, on_wall)
    return with_doubt(exercise, on_wall, on_simulated)


def second_start_decides(exercise: Exercise, on_simulated: Judgement, on_wall: Judgement) -> Judgement:
    """The judgement in real time, if it contradicts the one on simulated time; else the latter.

    Then the end of the first process counts, which was asked to end; but if the second one ended by itself, that does.
    """
    if on_wall.status != "graded" or _contradicts(exercise, on_simulated, on_wall):
        return with_doubt(exercise, on_wall)
    simulated, real = _recordings(on_simulated, on_wall)
    ended = real.process.ended_by == "itself" or real.process.limits_hit
    process = real.process if ended else replace(simulated.process, watched_for=real.process.watched_for)
    both = replace(simulated, process=process)
    return with_doubt(exercise, judge_recording(exercise, on_simulated.answer_sha256, both, real_life=True))


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

    return replace(on_wall, criteria=tuple(map(of_both, on_wall.criteria)))


def _contradicts(exercise: Exercise, on_simulated: Judgement, on_wall: Judgement) -> bool:
    """Whether a program that was started again behaved otherwise in real time than on simulated time.

    Where a script is played, all that is judged must be as before. Where none is, real time is too short to judge the
    rates again; so they are compared. How the program ended is not looked at, except that it ended too early.
    """
    simulated, real = _recordings(on_simulated, on_wall)
    if real.process.ended_by == "itself" and real.simulated_s < ENDS_EARLY_S:
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
    """Whether a program that ended by itself on simulated time had long been at its work.

    If one ends early, the wall clock sees its end as well.
    """
    published = any(recording.topic(name).arrivals for name in exercise.periods)
    return published and recording.simulated_s >= WORKED_PERIODS * exercise.plan.longest_period


def _is_any_undecided(exercise: Exercise, recording: Recording) -> bool:
    """Whether messages of a topic came of which it is not proved that they follow simulated time."""
    return any(
        recording.topic(name).arrivals and not recording.following.get(name, False)
        for name in exercise.periods
    )


def _is_final(recording: Recording, result: CriterionResult) -> bool:
    """Whether simulated time has the last word on this result: it judges the pace of a topic that follows the clock.

    At a fixed pace of that clock, a callback that sleeps for a moment would be late by many times that moment. That a
    topic stops while others go on is no matter of a moment.
    """
    return (recording.in_lockstep or not result.about_time) and recording.following.get(result.pace_of, False)


def _has_another_rate(simulated: Recording, real: Recording, topic: str) -> bool:
    """Whether a topic came at another rate in real time than on simulated time, if it came there at all."""
    seen = intervals_of(simulated, topic)
    return bool(seen) and rates_differ(median(seen), real, topic)
