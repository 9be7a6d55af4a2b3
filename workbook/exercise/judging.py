"""From an answer to a judgement: run it, record it, judge the recording.

The student's check and the instructor's grade both come through `judge`; they differ only in `thorough`.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

from workbook.criteria.garbled import field_check_note
from workbook.criteria.runner import CriterionError, CriterionResult, run_criteria
from workbook.exercise.answers import Answer, domains_named, syntax_mistake
from workbook.exercise.definition import Exercise
from workbook.exercise.doubt import doubt_about
from workbook.exercise.starting import StartedAnswer, write_program
from workbook.observing.process import NodeProcess
from workbook.observing.recording import Finding, Recording
from workbook.observing.typecheck import TypeCheckFailed, type_check
from workbook.observing.watch import PATIENCE_WITH_THE_END_S, SPEEDS, Observer, Watch, speeds_agree
from workbook.ros.scratch import remove_scratch, scratch_folder

REAL_LIFE_S = 8.0
FIELD_CHECKS_S = 2.0
FIELD_CHECKS_PERIODS = 1.5

JudgementStatus = Literal["graded", "infra_error"]


@dataclass(frozen=True)
class Judgement:
    """What came out for one answer. `provisional` is set when the wall clock has not had its word yet.

    `doubt`: why points that were lost may be lost without the answer's fault; empty for a conclusive judgement.
    """

    stem: str
    answer_sha256: str
    status: JudgementStatus
    reason: str | None
    criteria: tuple[CriterionResult, ...]
    recording: Recording | None
    provisional: bool = False
    watched_real_life: bool = False
    doubt: str = ""

    @property
    def score(self) -> float | None:
        if self.status != "graded":
            return None
        return round(sum(result.points for result in self.criteria), 6)

    @property
    def max_score(self) -> float:
        return sum(result.max_points for result in self.criteria)

    @property
    def full_marks(self) -> bool:
        return self.status == "graded" and all(result.status == "passed" for result in self.criteria)


Report = Callable[[Judgement], None]


def judge_recording(
    exercise: Exercise,
    answer_sha256: str,
    recording: Recording,
    *,
    provisional: bool = False,
    real_life: bool = False,
) -> Judgement:
    """Judge a recording without running anything. A criterion that crashes gives an `infra_error`."""
    try:
        results = run_criteria(exercise.criteria, recording)
    except CriterionError as error:
        return Judgement(exercise.stem, answer_sha256, "infra_error", str(error), (), recording)
    return Judgement(exercise.stem, answer_sha256, "graded", None, results, recording, provisional, real_life)


def _needs_wall_clock(exercise: Exercise, answer: Answer, judgement: Judgement) -> bool:
    recording = judgement.recording
    if recording is None or judgement.status != "graded":
        return False
    if recording.process.ended_by == "itself":
        return syntax_mistake(answer.text) is None
    if recording.follows_clock is None:
        return False
    if not recording.follows_clock or not speeds_agree(recording, tuple(exercise.periods)):
        return True
    return any(result.about_time for result in judgement.criteria)


def _with_doubt(exercise: Exercise, judgement: Judgement, on_robot: Judgement | None = None) -> Judgement:
    """The judgement, and whether it is conclusive. `on_robot`: what robot time had said of the same program."""
    recording = judgement.recording
    if judgement.status != "graded" or recording is None:
        return judgement
    before: tuple[CriterionResult, ...] = ()
    if on_robot is not None and on_robot.recording is not None and on_robot.recording.follows_clock:
        if speeds_agree(on_robot.recording, tuple(exercise.periods)):
            before = on_robot.criteria
    doubt = doubt_about(judgement.criteria, recording, exercise.plan, exercise.periods, before)
    return replace(judgement, doubt=doubt)


class Judge:
    """Judges answers to exercises, one after another, from one warm observer."""

    def __init__(self, observer: Observer, limits: Mapping[str, int] | None = None) -> None:
        self._observer = observer
        self._limits = dict(limits or {})

    def judge(
        self,
        exercise: Exercise,
        answer: Answer,
        *,
        thorough: bool = False,
        report: Report | None = None,
        enough: Callable[[], bool] = lambda: False,
        started: StartedAnswer | None = None,
    ) -> Judgement:
        """Judge one answer.

        `thorough`: as an instructor grades, a program that passes on robot time is kept running until eight real
        seconds after it was matched, unless `enough` cuts that short. `report` receives a provisional judgement as
        soon as there is one. `started`: this answer, if it runs already on the observer's domain.
        """
        if started is None:
            # On the very domain that it names, a program with a domain of its own would be taken for a right one.
            self._observer.keep_off(domains_named(answer.text))
        folder = scratch_folder("answer") if started is None else started.folder
        process = None if started is None else started.process
        try:
            program = write_program(folder, exercise.stem, answer) if process is None else process.program
            findings = None
            if exercise.source.kind == "static":
                try:
                    findings = type_check(answer.text, exercise.probes)
                except TypeCheckFailed as error:
                    return Judgement(exercise.stem, answer.sha256, "infra_error", str(error), (), None)
            judgement = self._on_both_clocks(
                exercise, answer, program, process, findings, thorough, report, enough
            )
            if any(result.garbled for result in judgement.criteria):
                return self._with_field_checks(exercise, answer, program, judgement)
            return judgement
        finally:
            remove_scratch(folder)

    def _on_both_clocks(
        self,
        exercise: Exercise,
        answer: Answer,
        program: Path,
        process: NodeProcess | None,
        findings: tuple[Finding, ...] | None,
        thorough: bool,
        report: Report | None,
        enough: Callable[[], bool],
    ) -> Judgement:
        """Judge on robot time where the exercise allows it, and on the wall clock where that is not enough."""
        on_robot: Judgement | None = None
        if exercise.source.clock == "simulated":
            with self._observer.watch(
                program,
                exercise.plan,
                "simulated",
                limits=self._limits,
                process=process,
                driver=exercise.driver,
            ) as watch:
                judgement = self._judge(exercise, answer, watch, findings)
                on_robot_time = not _needs_wall_clock(exercise, answer, judgement)
                if on_robot_time:
                    judgement = self._live_on(exercise, answer, watch, judgement, thorough, report, enough)
            if on_robot_time and not (exercise.to_the_end and thorough and judgement.full_marks):
                return _with_doubt(exercise, judgement)
            if on_robot_time:
                if report is not None:
                    report(judgement)
                return self._second_life(exercise, answer, program, judgement, enough)
            if report is not None:
                report(judgement_as_provisional(judgement))
            process = None
            on_robot = judgement
        with self._observer.watch(
            program, exercise.plan, "wall", limits=self._limits, process=process, driver=exercise.driver
        ) as watch:
            judgement = self._judge(exercise, answer, watch, findings)
            judgement = self._live_on(exercise, answer, watch, judgement, thorough, report, enough)
        return _with_doubt(exercise, judgement, on_robot)

    def _with_field_checks(
        self, exercise: Exercise, answer: Answer, program: Path, judgement: Judgement
    ) -> Judgement:
        """Run the program once more, briefly, with field checks on; what they say goes into the recording's notes."""
        recording = judgement.recording
        assert recording is not None
        plan = exercise.plan
        with self._observer.watch(
            program,
            plan,
            recording.clock,
            check_fields=True,
            limits=self._limits,
            driver=exercise.driver,
        ) as watch:
            watch.wait_until_seen()
            watch.keep_watching(
                max(FIELD_CHECKS_S, FIELD_CHECKS_PERIODS * plan.longest_period), speed=SPEEDS[-1]
            )
            process = watch.process_record()
            if process.ended_by is not None:
                process = watch.finish(recording).process
        recording = replace(recording, notes=(*recording.notes, field_check_note(process)))
        again = judge_recording(exercise, answer.sha256, recording, real_life=judgement.watched_real_life)
        return replace(again, doubt=judgement.doubt)

    def _judge(
        self, exercise: Exercise, answer: Answer, watch: Watch, findings: tuple[Finding, ...] | None
    ) -> Judgement:
        recording = replace(watch.observe(), findings=findings)
        if exercise.to_the_end:
            recording = watch.finish(recording, PATIENCE_WITH_THE_END_S, look_who_stays=True)
        real_life = exercise.to_the_end and recording.clock == "wall"
        return judge_recording(exercise, answer.sha256, recording, real_life=real_life)

    def _live_on(
        self,
        exercise: Exercise,
        answer: Answer,
        watch: Watch,
        judgement: Judgement,
        thorough: bool,
        report: Report | None,
        enough: Callable[[], bool],
    ) -> Judgement:
        """End the watch; when thorough, only after the program has lived its real seconds."""
        recording = judgement.recording
        assert recording is not None
        if exercise.to_the_end:
            return judgement  # it has been ended before it was judged
        if thorough and recording.process.ended_by is None and judgement.status == "graded":
            if report is not None:
                report(judgement)
            thorough = watch.keep_watching(REAL_LIFE_S, enough)
        recording = watch.finish(recording)
        real_life = thorough or recording.clock == "wall"
        return judge_recording(exercise, answer.sha256, recording, real_life=real_life)

    def _second_life(
        self,
        exercise: Exercise,
        answer: Answer,
        program: Path,
        judgement: Judgement,
        enough: Callable[[], bool],
    ) -> Judgement:
        """Where the end was judged on robot time: run the program again, for its real seconds."""
        recording = judgement.recording
        assert recording is not None
        with self._observer.watch(program, exercise.plan, "wall", limits=self._limits) as watch:
            watch.wait_until_seen()
            if not watch.keep_watching(REAL_LIFE_S, enough):
                return judgement
            process = watch.process_record()
        if process.ended_by == "itself":
            recording = replace(recording, process=process)
        else:
            recording = replace(
                recording, process=replace(recording.process, watched_for=process.watched_for)
            )
        return judge_recording(exercise, answer.sha256, recording, real_life=True)


def judgement_as_provisional(judgement: Judgement) -> Judgement:
    """The same judgement, marked as not final."""
    return replace(judgement, provisional=True)
