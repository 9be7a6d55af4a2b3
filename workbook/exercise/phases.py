"""Define the phases of judging a program.

Each phase is one *watch*: it runs the program, records it, and leads to a judgment or to the next phase.

`SimulatedTime` leads to `WallClock` if it can't judge a program, and to a `SecondStart` in real time if it can. An
exercise that can't be judged in simulated time at all begins with `WallClock`. `FieldChecks` comes last, if a message
is garbled.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Protocol

from workbook.criteria.vocabulary.field_checks import field_check_note
from workbook.exercise.answers import Answer
from workbook.exercise.definition import Exercise
from workbook.exercise.judgement import (
    Judgement,
    Report,
    judge_recording,
    judgement_as_provisional,
    with_kept_results,
)
from workbook.exercise.spins import repeated_init, spins_in
from workbook.exercise.two_runs import (
    REAL_LIFE_S,
    is_distrusted,
    needs_second_start,
    needs_wall_clock,
    plan_of_second_start,
    plan_on_wall_clock,
    second_start_decides,
    wall_clock_decides,
    with_inconclusive_reason,
)
from workbook.programs.spec import ProgramSpec
from workbook.recording.plan import Plan
from workbook.recording.recording import Clock, Finding, Recording
from workbook.watching.watch import PATIENCE_WITH_THE_END_S, Watch

FIELD_CHECKS_S = 2.0
FIELD_CHECKS_PERIODS = 1.5


def never() -> bool:
    """Return False. Used as `cancel_soak` for a watch that can't be cut short."""
    return False


@dataclass(frozen=True)
class JudgingRequest:
    """One answer to judge: the arguments of `Judge.judge`, and the program to run."""

    exercise: Exercise
    answer: Answer
    spec: ProgramSpec
    findings: tuple[Finding, ...] | None
    soak: bool
    report: Report
    cancel_soak: Callable[[], bool]

    def judged(self, recording: Recording, *, real_life: bool) -> Judgement:
        """Judge a recording of this answer."""
        return judge_recording(self.exercise, self.answer.sha256, recording, real_life=real_life)

    def observed(self, watch: Watch, cancel_soak: Callable[[], bool] = never) -> Judgement:
        """Watch the program as planned, and judge the recording.

        If the exercise judges the program's exit, stop the program before judging.
        """
        text = self.answer.text
        recording = replace(
            watch.observe(cancel_soak),
            findings=self.findings,
            spins=spins_in(text),
            repeated_init=repeated_init(text),
        )
        if self.exercise.to_the_end:
            recording = watch.finish(recording, PATIENCE_WITH_THE_END_S, look_who_stays=True)
        return self.judged(recording, real_life=self.exercise.to_the_end and recording.clock == "wall")

    def ended(self, watch: Watch, judgement: Judgement) -> Judgement:
        """Stop the program unless it has already exited. In a soak on the wall clock, let it keep running first."""
        recording, lived = judgement.recording, False
        assert recording is not None
        if self.exercise.to_the_end:
            return judgement
        if self.soak and recording.process.ended_by is None and judgement.status == "graded":
            self.report(judgement)
            if recording.clock == "wall" and (lived := watch.keep_watching(REAL_LIFE_S, self.cancel_soak)):
                recording = watch.with_its_nodes(recording)
        recording = watch.finish(recording)
        return self.judged(recording, real_life=lived or recording.clock == "wall")

    def concluded(self, judgement: Judgement) -> "JudgingPhase | Judgement":
        """Return the final judgment, or the field checks as the next phase if a criterion needs their error."""
        if any(result.recheck_fields for result in judgement.criteria):
            return FieldChecks(self, judgement)
        return judgement


Watched = tuple[ProgramSpec, Plan, Clock]
"""The program to start, the plan for watching it, and the clock."""


class JudgingPhase(Protocol):
    """One watch of a program, and the step that follows."""

    def watched(self) -> Watched:
        """Return this phase's program, plan, and clock."""

    def follow(self, watch: Watch) -> "JudgingPhase | Judgement":
        """Watch the program. Return the next phase, or the final judgment."""


@dataclass(frozen=True)
class SimulatedTime:
    """A normal run of the program, which the judge switches to simulated time."""

    case: JudgingRequest

    def watched(self) -> Watched:
        """Return the program, the exercise's plan, and simulated time as the clock."""
        return self.case.spec, self.case.exercise.plan, "simulated"

    def follow(self, watch: Watch) -> JudgingPhase | Judgement:
        """Judge the program in simulated time.

        If simulated time doesn't prove anything, return the wall clock as the next phase.
        """
        case = self.case
        judgement = case.observed(watch)
        if needs_wall_clock(case.exercise, case.answer, judgement):
            case.report(judgement_as_provisional(judgement))
            return WallClock(case, judgement)
        judgement = case.ended(watch, judgement)
        if not case.soak or not needs_second_start(judgement):
            return case.concluded(with_inconclusive_reason(case.exercise, judgement))
        if case.exercise.to_the_end:
            case.report(judgement)
        return SecondStart(case, judgement)


@dataclass(frozen=True)
class WallClock:
    """A normal run of the program, judged in real time.

    `on_simulated`: the earlier judgment in simulated time, if any.
    """

    case: JudgingRequest
    on_simulated: Judgement | None = None

    def watched(self) -> Watched:
        """Return the program and a plan for real time, long enough to repeat its behavior in simulated time."""
        return self.case.spec, plan_on_wall_clock(self.case.exercise, self.on_simulated), "wall"

    def follow(self, watch: Watch) -> JudgingPhase | Judgement:
        """Judge the program in real time."""
        case = self.case
        judgement = case.ended(watch, case.observed(watch))
        proved = None if is_distrusted(case.answer) else self.on_simulated
        return case.concluded(wall_clock_decides(case.exercise, proved, judgement))


@dataclass(frozen=True)
class SecondStart:
    """A second run of the program, in real time. The program must behave as it did in simulated time."""

    case: JudgingRequest
    on_simulated: Judgement

    def watched(self) -> Watched:
        """Return the program and a plan to watch it in real time until the script ends, for at least eight seconds."""
        return self.case.spec, plan_of_second_start(self.case.exercise, self.on_simulated), "wall"

    def follow(self, watch: Watch) -> JudgingPhase | Judgement:
        """Compare the two runs. If the second one is cut short, only the first one counts."""
        case = self.case
        on_wall = replace(case.observed(watch, case.cancel_soak), watched_real_life=True)
        if case.cancel_soak():
            return case.concluded(with_inconclusive_reason(case.exercise, self.on_simulated))
        return case.concluded(second_start_decides(case.exercise, self.on_simulated, on_wall))


@dataclass(frozen=True)
class FieldChecks:
    """A short run of the program with field checks, which make message classes reject values of the wrong type.

    The resulting error is added to the recording's notes.
    """

    case: JudgingRequest
    judgement: Judgement

    def watched(self) -> Watched:
        """Return the program with field checks enabled, a plan for its first messages, and the judgment's clock."""
        plan = self.case.exercise.plan
        seconds = max(FIELD_CHECKS_S, FIELD_CHECKS_PERIODS * plan.longest_period)
        plan = replace(plan, simulated_seconds=seconds, wall_seconds=seconds)
        return replace(self.case.spec, check_fields=True), plan, self._recording.clock

    def follow(self, watch: Watch) -> Judgement:
        """Judge the recording again, this time with the field checks' error in its notes.

        This doesn't change whether the judgment is conclusive.
        """
        process = watch.observe(never).process
        if process.ended_by is not None:
            process = watch.finish(self._recording).process
        recording = replace(self._recording, notes=(*self._recording.notes, field_check_note(process)))
        again = self.case.judged(recording, real_life=self.judgement.watched_real_life)
        again = with_kept_results(self.judgement, again)
        return replace(
            again, inconclusive_reason=self.judgement.inconclusive_reason, end_only=self.judgement.end_only
        )

    @property
    def _recording(self) -> Recording:
        assert self.judgement.recording is not None
        return self.judgement.recording


def first_phase(case: JudgingRequest) -> JudgingPhase:
    """Return simulated time as the first phase if the exercise allows it, otherwise the wall clock."""
    return SimulatedTime(case) if case.exercise.source.clock == "simulated" else WallClock(case)
