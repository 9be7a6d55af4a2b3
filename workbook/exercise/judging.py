"""From an answer to a judgement: run it, record it, judge the recording.

The student's check and the instructor's grade both come through `judge`. The phases that a program goes through are in
`phases`; what two runs of it mean together is in `two_runs`.
"""

import secrets
from collections.abc import Callable

from workbook.exercise.answers import Answer, domains_named
from workbook.exercise.definition import Exercise
from workbook.exercise.early_start import StartedAnswer, write_program
from workbook.exercise.judgement import Judgement, Report
from workbook.exercise.phases import JudgingPhase, JudgingRequest, first_phase, never
from workbook.programs.process import NodeProcess
from workbook.programs.spec import ProgramSpec
from workbook.recording.limits import NO_LIMITS, Limits
from workbook.ros.scratch import remove_scratch, scratch_folder
from workbook.typechecking.typecheck import TypeCheckFailed, type_check
from workbook.watching.observer import Observer

SEED_BITS = 32


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
        soak: bool = False,
        report: Report | None = None,
        cancel_soak: Callable[[], bool] = never,
        started: StartedAnswer | None = None,
        seed: int | None = None,
    ) -> Judgement:
        """Judge one answer.

        `soak`: a program that was judged on simulated time is started again, and watched for eight real seconds, unless
        `cancel_soak` cuts that short. What it does then must be as before. On the wall clock, it is kept running for as
        long. `report` receives each judgement that comes before the last one. `started`: this answer, if it runs
        already on the observer's domain. `seed`: what the script is drawn from, to repeat a run; None: another one each
        time.
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
            case = JudgingRequest(exercise, answer, spec, findings, soak, report or _to_nobody, cancel_soak)
            return self._through_phases(first_phase(case), process)
        finally:
            remove_scratch(folder)

    def _through_phases(self, phase: JudgingPhase, process: NodeProcess | None) -> Judgement:
        """Watch one phase after another, up to the judgement. `process`: the program, if it runs already."""
        after: JudgingPhase | Judgement = phase
        while not isinstance(after, Judgement):
            spec, plan, clock = after.watched()
            with self._observer.watch(spec, plan, clock, process) as watch:
                after = after.follow(watch)
            process = None  # the next phase starts the program anew
        return after
