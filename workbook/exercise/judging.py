"""Judge an answer: run it, record what it does, and judge the recording.

The student's check and the instructor's grading both use `Judge.judge`. The module `phases` defines the phases of
judging a program, and `two_runs` combines the results of two runs.
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
from workbook.watching.watch import Watch

SEED_BITS = 32


def _to_nobody(judgement: Judgement) -> None:
    """Ignore a judgment, for callers that don't want reports."""


class Judge:
    """Judges answers to exercises, one after another, with one observer that stays ready."""

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

        `soak`: after a judgment in simulated time, start the program again and watch it for eight real seconds, unless
        `cancel_soak` returns True. The program must behave as before. A program that was judged on the wall clock isn't
        started again but keeps running until the eight seconds are over. `report` receives each judgment before the
        final one. `started`: this answer, if it's already running on the observer's domain. `seed`: the script's seed,
        for repeating a run; None draws a new seed.
        """
        exercise = exercise.drawn(secrets.randbits(SEED_BITS) if seed is None else seed)
        if started is None:
            # if the observer used the domain that the program sets itself, that mistake would go unnoticed
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
        """Watch one phase after another until there is a judgment. `process`: the program, if it's already running."""
        after: JudgingPhase | Judgement = phase
        while not isinstance(after, Judgement):
            spec, plan, clock = after.watched()
            with Watch(self._observer, spec, plan, clock, process) as watch:
                after = after.follow(watch)
            process = None  # the next phase starts the program again
        return after
