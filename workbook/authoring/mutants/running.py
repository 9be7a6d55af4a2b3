"""Generate and judge the mutants of exercises and write the reports. `make mutants` runs this."""

import hashlib
import os
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from workbook.authoring.mutants.drawing import MOST, draw
from workbook.authoring.mutants.judged import Cache, JudgeAll, Marks, judge_programs, judge_sha256
from workbook.authoring.mutants.making import Mutant
from workbook.authoring.mutants.programs import all_mutants, inputs_of, right_programs
from workbook.authoring.mutants.report import Report, filled, read_report, write_report
from workbook.authoring.tree import AuthoringError, Tree
from workbook.exercise.answers import Answer
from workbook.exercise.definition import Exercise, load_exercise
from workbook.exercise.judgement import Judgement
from workbook.grading.judges import Job
from workbook.grading.slots.scheduler import judge_all

Say = Callable[[str], None]
WAITING = 3
"""Slots per processor for exercises on the wall clock, because their programs spend most of their time waiting."""
CHANCES = 3
"""The number of times that a right answer is judged before we report that it doesn't get full marks."""


def on_slots(slots: int | None = None) -> JudgeAll:
    """Return a function that judges jobs on this machine, with `slots` slots and the best available isolation.

    If `slots` is None, use one slot per processor, or `WAITING` slots per processor if programs use the wall clock.
    """
    from workbook.grading.single import best_isolation

    isolation = best_isolation()
    cores = len(os.sched_getaffinity(0))

    def judge(jobs: Sequence[Job[str]]) -> Iterator[tuple[Job[str], Judgement]]:
        waits = any(load_exercise(stem).source.clock == "wall" for stem in {job.stem for job in jobs})
        count = slots or (cores * WAITING if waits else cores)
        return judge_all(jobs, count, soak=False, isolation=isolation)

    return judge


def report_mutants(
    tree: Tree, stems: Iterable[str], judge: JudgeAll, *, most: int = MOST, say: Say = print
) -> list[Report]:
    """Judge at most `most` mutants of each of these exercises. Write the reports and return them.

    Raises:
        AuthoringError: a right answer doesn't get full marks, or a report can't be read.
    """
    reports = []
    for stem in stems:
        began = time.monotonic()
        reports.append(report_one(tree, stem, judge, most=most, say=say))
        say(f"{reports[-1].summary()}   {time.monotonic() - began:.0f} s")
    return reports


def report_one(tree: Tree, stem: str, judge: JudgeAll, *, most: int, say: Say = print) -> Report:
    """Judge at most `most` mutants of one exercise. Write its report and return it.

    Raises:
        AuthoringError: see `report_mutants`.
    """
    path = report_path(tree, stem)
    exercise = load_exercise(stem, tree.root)
    before = read_report(path)
    if exercise.to_the_end:
        before = replace(before, judged_here=tuple(sorted({*before.judged_here, "ending"})))
    programs = right_programs(tree, exercise, before.right)
    mutants = all_mutants(exercise, programs)
    drawn = draw(
        mutants,
        most,
        first={one.id for one in before.survivors},
        excused=lambda mutant: before.excuse(mutant) is not None,
    )
    say(f"{stem}: {len(mutants)} mutants of {', '.join(programs)}; {len(drawn)} are judged")
    cache = cache_of(tree, exercise)
    _must_be_right(stem, programs, cache, judge)
    by_id = {one.id: one for one in drawn}

    def tell(name: str, outcome: Marks) -> None:
        if outcome.full_marks and before.excuse(by_id[name]) is None:
            say(as_line(by_id[name]))

    answers = {one.id: one.answer for one in drawn}
    outcomes = judge_programs(stem, answers, cache, judge, tell)
    right = tuple(name.removeprefix("right/") for name in programs if name.startswith("right/"))
    if len(outcomes) < len(drawn):
        say(f"{stem}: {len(drawn) - len(outcomes)} could not be judged; another run tries them again")
    judged = {name: (by_id[name], outcomes[name].lost) for name in by_id if name in outcomes}
    report = replace(filled(before, len(mutants), judged), right=right, inputs=inputs_of(exercise, programs))
    write_report(report, path)
    return report


def cache_of(tree: Tree, exercise: Exercise) -> Cache:
    """Return the cache of outcomes under the exercise's current criteria and the current judge."""
    judged_by = f"{exercise.stem} {exercise.criteria_sha256} {judge_sha256()}"
    path = tree.root / "build" / "mutants" / f"{exercise.stem}.jsonl"
    return Cache(path, hashlib.sha256(judged_by.encode()).hexdigest())


def _must_be_right(stem: str, programs: Mapping[str, Answer], cache: Cache, judge: JudgeAll) -> None:
    """Raise AuthoringError unless all right answers get full marks.

    The mutants of an answer without full marks would prove nothing.
    """
    for chances_left in reversed(range(CHANCES)):
        outcomes = judge_programs(stem, programs, cache, judge, keep=lambda outcome: outcome.full_marks)
        lost = {base: outcome for base, outcome in outcomes.items() if not outcome.full_marks}
        if lost.keys() or outcomes.keys() != programs.keys():
            if chances_left:
                continue
            told = "; ".join(
                f"{base} loses {', '.join(one.lost)} ({one.cause})" for base, one in lost.items()
            )
            raise AuthoringError(
                f"{stem}: a right program does not get full marks, so its mutants prove nothing: "
                f"{told or 'it could not be judged'}. Try again when the machine is calmer, or prove the exercise."
            )
        return


def as_line(mutant: Mutant) -> str:
    """Return a line that describes a mutant with full marks."""
    place = f"{mutant.base}:{mutant.line} {mutant.scope}"
    return f"  full marks  {mutant.id}  {place}  [{mutant.operator}]  {mutant.before}  →  {mutant.after}"


def report_path(tree: Tree, stem: str) -> Path:
    """Return the path of an exercise's report."""
    return tree.mutants / f"{stem}.toml"
