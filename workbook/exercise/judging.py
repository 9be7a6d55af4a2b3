"""From an answer to a judgement: run it, record it, judge the recording.

The student's check and the instructor's grade both come through `judge`.
"""

import secrets
from collections.abc import Callable
from dataclasses import dataclass, replace
from statistics import median

from workbook.criteria.runner import CriterionResult
from workbook.criteria.vocabulary.field_checks import field_check_note
from workbook.exercise.answers import Answer, domains_named, syntax_mistake
from workbook.exercise.conclusiveness import find_doubt
from workbook.exercise.definition import Exercise
from workbook.exercise.early_start import StartedAnswer, write_program
from workbook.exercise.judgement import Judgement, Report, judge_recording, judgement_as_provisional
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.limits import NO_LIMITS, Limits
from workbook.recording.plan import Plan
from workbook.recording.recording import Finding, Recording
from workbook.ros.scratch import remove_scratch, scratch_folder
from workbook.typechecking.typecheck import TypeCheckFailed, type_check
from workbook.watching.following import intervals_of, rates_differ
from workbook.watching.observer import Observer
from workbook.watching.watch import PATIENCE_WITH_THE_END_S, Watch

SEED_BITS = 32
REAL_LIFE_S = 8.0
CRASHES_WITHIN_S = 1.5
"""An end so soon (s) after the switch back to real time may be due to the switch."""
FIELD_CHECKS_S = 2.0
FIELD_CHECKS_PERIODS = 1.5
WORKED_PERIODS = 3
"""Of simulated time, the longest judged period: so long the wall clock watches in any case."""

STOPPED_PERIODS = 2.5
"""A topic that is silent for so many of its periods has stopped."""
MOST_WALL_S = 26.0
"""The wall clock watches at most so long (s) for a topic to stop: twenty seconds of messages, and the silence after."""


def _needs_wall_clock(exercise: Exercise, answer: Answer, judgement: Judgement) -> bool:
    recording = judgement.recording
    if recording is None or judgement.status != "graded":
        return False
    if recording.clock == "wall":  # to be asked whether it can be switched may end a program
        return recording.process.ended_by == "itself" and recording.follows_clock is False
    if recording.process.ended_by == "itself":
        return syntax_mistake(answer.text) is None and not _ended_for_good(exercise, recording)
    if not recording.follows_clock or any(_is_undecided(recording, topic) for topic in exercise.periods):
        return True
    return any(result.about_time and not _is_final(recording, result) for result in judgement.criteria)


def _ended_for_good(exercise: Exercise, recording: Recording) -> bool:
    """Whether a program that ended by itself on simulated time had long been at its work.

    If one ends early, the wall clock sees its end as well.
    """
    published = any(recording.topic(name).arrivals for name in exercise.periods)
    return published and recording.robot_s >= WORKED_PERIODS * exercise.plan.longest_period


def _is_undecided(recording: Recording, topic: str) -> bool:
    """Whether messages came of which it is not proved that they follow robot time."""
    return bool(recording.topic(topic).arrivals) and not recording.following.get(topic, False)


def _is_final(recording: Recording, result: CriterionResult) -> bool:
    """Whether robot time has the last word on this result: it judges the pace of a topic that follows the clock.

    At a fixed pace of that clock, a callback that sleeps for a moment would be late by many times that moment. That a
    topic stops while others go on is no matter of a moment.
    """
    return (recording.in_lockstep or not result.about_time) and recording.following.get(result.pace_of, False)


def _wall_plan(exercise: Exercise, on_robot: Judgement | None) -> Plan:
    """The plan for the wall clock: long enough for a topic to stop there, too, if it did so on robot time.

    A topic that brings few messages does not prove that it follows robot time.
    """
    plan, seen = exercise.plan, on_robot.recording if on_robot is not None else None
    if seen is None:
        return plan
    needed = [plan.wall_s]
    for name, period in exercise.periods.items():
        arrivals = seen.topic(name).arrivals
        if arrivals and seen.robot_s - arrivals[-1].t > STOPPED_PERIODS * period:
            needed.append((len(arrivals) + STOPPED_PERIODS) * period)
    return replace(plan, wall_seconds=max(one for one in needed if one <= max(MOST_WALL_S, plan.wall_s)))


def _with_what_robot_time_proved(on_robot: Judgement, on_wall: Judgement) -> Judgement:
    """The judgement of the wall clock, but for the pace of topics that follow robot time.

    A shorter watch in real time does not overrule what many messages of robot time have shown.
    """
    recording = on_robot.recording
    if recording is None or on_wall.status != "graded":
        return on_wall
    before = {result.id: result for result in on_robot.criteria}
    results = tuple(
        before.get(result.id, result)
        if any(_is_final(recording, one) for one in (result, before.get(result.id, result)))
        else result
        for result in on_wall.criteria
    )
    return replace(on_wall, criteria=results)


def _with_doubt(exercise: Exercise, judgement: Judgement, on_robot: Judgement | None = None) -> Judgement:
    """The judgement, and whether it is conclusive. `on_robot`: what robot time had said of the same program."""
    recording = judgement.recording
    if judgement.status != "graded" or recording is None:
        return judgement
    before: tuple[CriterionResult, ...] = ()
    if on_robot is not None and on_robot.recording is not None and on_robot.recording.follows_clock:
        if not any(_is_undecided(on_robot.recording, topic) for topic in exercise.periods):
            before = on_robot.criteria
    doubt = find_doubt(judgement.criteria, recording, exercise.plan, exercise.periods, before)
    return replace(judgement, doubt=doubt.reason, end_only=doubt.end_only)


@dataclass(frozen=True)
class _Case:
    """One answer to judge: what `Judge.judge` was given, and the program to run."""

    exercise: Exercise
    answer: Answer
    spec: ProgramSpec
    findings: tuple[Finding, ...] | None
    thorough: bool
    report: Report
    enough: Callable[[], bool]

    def judged(self, recording: Recording, *, real_life: bool) -> Judgement:
        return judge_recording(self.exercise, self.answer.sha256, recording, real_life=real_life)


def _real_life_s(exercise: Exercise) -> float:
    """How long (s) after its match a program lives: also long enough to see each of its rates in real time."""
    return max(REAL_LIFE_S, exercise.plan.wall_s) if exercise.periods else REAL_LIFE_S


def _contradicts(case: _Case, judgement: Judgement, simulated: Recording, real: Recording) -> bool:
    """Whether a program behaved otherwise in real time than on simulated time: its rates, types or values.

    The script is not played again. So what it makes a program publish is missing then, and only rates can be compared:
    with those that the exercise asks for. An end is judged as any other, unless it comes right after the switch.
    """
    ended = real.process.ended_by == "itself"
    if ended and real.robot_s < CRASHES_WITHIN_S:
        return True
    scripted = bool(case.exercise.plan.script)
    for topic, period in case.exercise.periods.items():
        seen = [period] if scripted else intervals_of(simulated, topic)
        if seen and rates_differ(median(seen), real, topic):
            return True
    if scripted or ended:
        return False
    before = {result.id: result.status for result in judgement.criteria}
    return any(
        result.status in ("failed", "partial") and before[result.id] == "passed"
        for result in case.judged(real, real_life=True).criteria
        if not (result.about_time or result.about_end)
    )


def _to_nobody(judgement: Judgement) -> None:
    """The report of whoever wants none."""


class Judge:
    """Judges answers to exercises, one after another, from one warm observer."""

    def __init__(self, observer: Observer, limits: Limits = NO_LIMITS) -> None:
        self._observer = observer
        self._limits = limits

    def judge(
        self,
        exercise: Exercise,
        answer: Answer,
        *,
        thorough: bool = False,
        report: Report | None = None,
        enough: Callable[[], bool] = lambda: False,
        started: StartedAnswer | None = None,
        seed: int | None = None,
    ) -> Judgement:
        """Judge one answer.

        `thorough`: a program that was judged on simulated time is switched back and kept running until eight real
        seconds after it was matched, unless `enough` cuts that short. What it publishes then must be as before.
        `report` receives the judgement before that. `started`: this answer, if it runs already on the observer's
        domain. `seed`: what the script is drawn from, to repeat a run; None: another one each time.
        """
        exercise = exercise.drawn(secrets.randbits(SEED_BITS) if seed is None else seed)
        if started is None:
            # On the very domain that it names, a program with a domain of its own would be taken for a right one.
            self._observer.keep_off(domains_named(answer.text))
        folder = scratch_folder("answer") if started is None else started.folder
        process = None if started is None else started.process
        try:
            program = write_program(folder, exercise.stem, answer) if process is None else process.spec.file
            findings = None
            if exercise.source.kind == "static":
                try:
                    findings = type_check(answer.text, exercise.probes)
                except TypeCheckFailed as error:
                    return Judgement(exercise.stem, answer.sha256, "infra_error", str(error), (), None)
            spec = ProgramSpec(program, driver=exercise.driver, limits=self._limits)
            case = _Case(exercise, answer, spec, findings, thorough, report or _to_nobody, enough)
            judgement = self._on_both_clocks(case, process)
            if any(result.recheck_fields for result in judgement.criteria):
                return self._with_field_checks(case, judgement)
            return judgement
        finally:
            remove_scratch(folder)

    def _on_both_clocks(self, case: _Case, process: NodeProcess | None) -> Judgement:
        """Judge on simulated time where exercise and program allow it, and on the wall clock where they do not."""
        exercise = case.exercise
        on_robot: Judgement | None = None
        if exercise.source.clock == "simulated":
            with self._observer.watch(case.spec, exercise.plan, "simulated", process) as watch:
                judgement = self._judge(case, watch)
                if _needs_wall_clock(exercise, case.answer, judgement):
                    on_robot, lived = judgement, None
                else:
                    lived = self._live_on(case, watch, judgement)
            if lived is not None and not (exercise.to_the_end and case.thorough and lived.full_marks):
                return _with_doubt(exercise, lived)
            if lived is not None:
                case.report(lived)
                lived = self._second_life(case, lived)
            if lived is not None:
                return lived
            case.report(judgement_as_provisional(judgement))
            process = None
        with self._observer.watch(case.spec, _wall_plan(exercise, on_robot), "wall", process) as watch:
            judgement = self._judge(case, watch)
            judgement = self._live_on(case, watch, judgement) or judgement
        if on_robot is not None:
            judgement = _with_what_robot_time_proved(on_robot, judgement)
        return _with_doubt(exercise, judgement, on_robot)

    def _with_field_checks(self, case: _Case, judgement: Judgement) -> Judgement:
        """Run the program once more, briefly, with field checks on; what they say goes into the recording's notes."""
        recording = judgement.recording
        assert recording is not None
        plan = case.exercise.plan
        seconds = max(FIELD_CHECKS_S, FIELD_CHECKS_PERIODS * plan.longest_period)
        plan = replace(plan, robot_seconds=seconds, wall_seconds=seconds)
        with self._observer.watch(replace(case.spec, check_fields=True), plan, recording.clock) as watch:
            process = watch.observe().process
            if process.ended_by is not None:
                process = watch.finish(recording).process
        recording = replace(recording, notes=(*recording.notes, field_check_note(process)))
        again = case.judged(recording, real_life=judgement.watched_real_life)
        return replace(again, doubt=judgement.doubt, end_only=judgement.end_only)

    def _judge(self, case: _Case, watch: Watch) -> Judgement:
        recording = replace(watch.observe(), findings=case.findings)
        if case.exercise.to_the_end:
            recording = watch.finish(recording, PATIENCE_WITH_THE_END_S, look_who_stays=True)
        real_life = case.exercise.to_the_end and recording.clock == "wall"
        return case.judged(recording, real_life=real_life)

    def _live_on(self, case: _Case, watch: Watch, judgement: Judgement) -> Judgement | None:
        """End the watch; when thorough, only after the program has lived its real seconds.

        Returns None where these contradict what was seen on simulated time. That need not be the program's fault: on
        its way back, rclpy's MultiThreadedExecutor may crash (https://github.com/ros2/rclpy/issues/1142), and a node
        that compares times of `get_clock().now()` sees a jump. So only a plain start on the wall clock can tell.
        """
        recording, lived, exercise = judgement.recording, False, case.exercise
        assert recording is not None
        if exercise.to_the_end:
            return judgement  # it has been ended before it was judged
        if case.thorough and recording.process.ended_by is None and judgement.status == "graded":
            case.report(judgement)
            lived = watch.keep_watching(_real_life_s(exercise), case.enough)
            if recording.clock == "simulated" and (lived or not watch.is_back):
                real = watch.in_real_time(recording)
                if real is None or _contradicts(case, judgement, recording, real):
                    return None
            if lived:
                recording = watch.with_its_life(recording)
        recording = watch.finish(recording)
        return case.judged(recording, real_life=lived or recording.clock == "wall")

    def _second_life(self, case: _Case, judgement: Judgement) -> Judgement | None:
        """Where the end was judged on robot time: run the program again, for its real seconds.

        Returns None where these contradict what was seen on simulated time, as `_live_on` does.
        """
        recording = judgement.recording
        assert recording is not None
        spec = replace(case.spec, driver=None)
        if recording.clock == "wall":
            return _with_doubt(case.exercise, judgement)
        with self._observer.watch(spec, case.exercise.plan, "wall") as watch:
            watch.begin_in_real_time()
            if not watch.keep_watching(_real_life_s(case.exercise), case.enough):
                return judgement
            real = watch.in_real_time(recording)
            process = watch.process_record()
        if real is None or _contradicts(case, judgement, recording, real):
            return None
        if process.ended_by == "itself":
            recording = replace(recording, process=process)
        else:
            recording = replace(
                recording, process=replace(recording.process, watched_for=process.watched_for)
            )
        return case.judged(recording, real_life=True)
