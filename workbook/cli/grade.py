"""`workbook grade`: judge a folder of answers, and write the gradebook."""

import argparse
import os
import signal
from collections.abc import Sequence
from contextlib import AbstractContextManager, nullcontext
from typing import TYPE_CHECKING

from workbook.cli import terminal
from workbook.cli.grade_appeals import lines_of, only_override, say_changes, take
from workbook.cli.grade_options import SLOTS_PER_CORE, add_options, gradebook_options, roster
from workbook.cli.grade_screen import (
    GradeScreen,
    Stopping,
    about_lateness,
    conclude,
    conclude_regrading,
    conclude_repetition,
    say_broken,
)
from workbook.cli.grade_similar import list_similar

if TYPE_CHECKING:
    from workbook.exercise.definition import Exercise
    from workbook.grading.appeals import OverrideLine
    from workbook.grading.batch import Batch
    from workbook.grading.gradebook import GradebookOptions
    from workbook.grading.judges import GradingBackend
    from workbook.isolation.tiers import Isolation


def register(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand with its options."""
    parser = subparsers.add_parser(
        "grade",
        help="judge a folder of answers",
        description="Judge every answer below PATH and write results.jsonl (one line per attempt) and grades.csv to "
        "DIR. If a run was stopped or killed, the next one continues where it left off. Unchanged answers aren't run "
        "again.",
    )
    add_options(parser)
    parser.set_defaults(run=run)


def _exercise_name(options: argparse.Namespace) -> str:
    from workbook.exercise.answers import Ungradable
    from workbook.exercise.course import course_folder
    from workbook.exercise.source import stems
    from workbook.grading.hand_ins import infer_exercise

    if options.exercise:
        return str(options.exercise)
    found = infer_exercise(options.paths, stems(course_folder() / "solutions"))
    if len(found) == 1:
        return found[0]
    if found:
        raise Ungradable(
            f"the files answer several exercises: {', '.join(found)}. Choose one with --exercise"
        )
    raise Ungradable("the file names don't show which exercise this is. Name it with --exercise")


def _isolation(wanted: str) -> "Isolation":
    """Return the isolation tier named `wanted`, which says how programs are isolated. "auto" means the sandbox.

    Raises NoSandbox if that tier doesn't work on this machine. A weaker tier is never chosen automatically.
    """
    from workbook.grading.tier_check import best_below_sandbox, tier_problem
    from workbook.isolation.bubblewrap import NoSandbox
    from workbook.isolation.tiers import BEST_FIRST, covers, leaves_open, named_tier

    isolation: Isolation = BEST_FIRST[0] if wanted == "auto" else named_tier(wanted)
    problem = tier_problem(isolation)
    if problem is None:
        return isolation
    if isolation == "sandbox":
        best = best_below_sandbox()
        raise NoSandbox(
            f"programs cannot be sandboxed on this machine: {problem}. The best that works here is {best}: "
            f"{covers(best)}. {leaves_open(best)} If that is enough for these answers, add --isolation {best}"
        )
    raise NoSandbox(f"--isolation {isolation} does not work on this machine: {problem}")


def run(options: argparse.Namespace) -> int:
    """Carry out `workbook grade`, and return the exit code.

    The exit code is 2 if, for example, an option is wrong or the isolation tier doesn't work.
    """
    from workbook.exercise.answers import Ungradable
    from workbook.exercise.course import NoCourse
    from workbook.exercise.definition import OWN_CRITERIA, BrokenCriteria, load_exercise, own_criteria
    from workbook.exercise.source import SourceError, UnknownExercise
    from workbook.grading.judges import NoJudges
    from workbook.grading.roster import BadOption
    from workbook.grading.similar import NoComparison
    from workbook.isolation.bubblewrap import NoSandbox

    try:
        books = gradebook_options(options)
        if options.criteria is not None:
            if not options.criteria.is_dir():
                raise BadOption(f"--criteria {options.criteria}: there is no such folder")
            os.environ[OWN_CRITERIA] = str(options.criteria.resolve())
        _check_paths(options, books.formats)
        lines = lines_of(options)
        exercise = load_exercise(_exercise_name(options))
        if options.criteria is not None and own_criteria(exercise.stem) is None:
            raise BadOption(f"--criteria {options.criteria}: the folder has no {exercise.stem}.py")
        if options.similar:
            return list_similar(options, exercise)
        if options.regrade:
            return _regrade(options, exercise, books, lines)
        if not options.paths:
            return only_override(options, exercise, books, lines)
        return _grade(options, exercise, books, lines)
    except (
        BadOption,
        Ungradable,
        UnknownExercise,
        NoCourse,
        BrokenCriteria,
        SourceError,
        NoSandbox,
        NoJudges,
        NoComparison,
        OSError,
    ) as error:
        terminal.complain("grade", error)
        return 2


def _check_paths(options: argparse.Namespace, formats: Sequence[str]) -> None:
    """Check the paths and options.

    Raises BadOption if there is nothing to grade or if an option would have no effect.
    """
    from workbook.grading.roster import BadOption

    for first, second in (
        ("regrade", "paths"),
        ("regrade", "repeat"),
        ("regrade", "retry_stopped"),
        ("repeat", "override"),
    ):
        if getattr(options, first) and getattr(options, second):
            other = "a path" if second == "paths" else f"--{second.replace('_', '-')}"
            raise BadOption(f"{other} has no effect with --{first}: leave one of the two out")
    if options.column is not None and not {"canvas", "moodle"} & set(formats):
        raise BadOption("--column needs --format canvas or --format moodle")
    if options.regrade and not options.exercise:
        raise BadOption("--regrade needs --exercise, because it reads results, not files")
    if not options.regrade and not options.paths:
        if options.override is None:
            raise BadOption("name a folder with answers, or files")
        if not options.exercise:
            raise BadOption(
                "--override without a folder needs --exercise, because it reads results, not files"
            )


def _judges(
    options: argparse.Namespace, exercise: "Exercise", screen: GradeScreen
) -> "AbstractContextManager[GradingBackend]":
    """Return the grading backend, and print which one it is.

    The backend consists either of local slots, which are processes that judge answers, or of a farm of several
    machines. Raises BadOption, NoSandbox, or NoJudges.
    """
    from workbook.grading.roster import BadOption
    from workbook.grading.slots.scheduler import LocalSlots
    from workbook.isolation.tiers import meets_others

    if options.farm is not None:
        return _farm(options, exercise.stem, screen)
    usual = SLOTS_PER_CORE[exercise.source.clock] * (os.cpu_count() or 1)
    slots = usual if options.slots is None else options.slots
    if slots < 1:
        raise BadOption("--slots must be at least 1")
    isolation = _isolation(options.isolation)
    more = ", and more while processors are idle" if options.slots is None else ""
    at_once = "one answer after another" if meets_others(isolation) else f"{slots} answers at a time{more}"
    screen.say(f"Grading {exercise.stem}, {at_once}. Isolation: {isolation}{_warning(isolation)}.")
    return nullcontext(LocalSlots(slots, isolation, fills=options.slots is None))


def _farm(
    options: argparse.Namespace, stem: str, screen: GradeScreen
) -> "AbstractContextManager[GradingBackend]":
    """Connect to a farm, and print its size. The isolation isn't checked here, because only the workers run answers."""
    from workbook.grading.farm import Farm
    from workbook.grading.farm_connection import check_address
    from workbook.grading.roster import BadOption

    if options.slots is not None:
        raise BadOption(
            "--slots is for this machine. On a farm, each worker sets its own number: dask worker --nthreads 16"
        )
    check_address(options.farm)
    isolation: Isolation = "sandbox" if options.isolation == "auto" else options.isolation
    farm = Farm(options.farm, isolation, screen.say)
    workers = "1 worker" if farm.machines == 1 else f"{farm.machines} workers"
    screen.say(
        f"Grading {stem} on {farm.places} slots of {workers} at {options.farm}. "
        f"Isolation: {isolation}{_warning(isolation)}."
    )
    return farm


def _warning(isolation: "Isolation") -> str:
    from workbook.isolation.tiers import covers, leaves_open, unfiltered

    if isolation == "sandbox" and not unfiltered(isolation):
        return ""
    return f": {covers(isolation)}. {leaves_open(isolation).rstrip('.')}"


def _grade(
    options: argparse.Namespace,
    exercise: "Exercise",
    books: "GradebookOptions",
    lines: "Sequence[OverrideLine]",
) -> int:
    from workbook.grading.batch import Batch
    from workbook.grading.gradebook import write_gradebook

    whose = roster(options)
    screen = GradeScreen()
    with _judges(options, exercise, screen) as judges:
        batch = Batch(
            exercise,
            options.out,
            judges,
            whose,
            retry_stopped=options.retry_stopped,
            seed=options.seed,
        )
        batch.check_paths(options.paths)
        options.out.mkdir(parents=True, exist_ok=True)
        if options.repeat is not None:
            return _repeat(options, exercise, batch, judges)
        stopping = Stopping()
        before = signal.signal(signal.SIGINT, stopping)
        try:
            summary = batch.run(options.paths, screen.show, stop=lambda: stopping.wanted)
        finally:
            signal.signal(signal.SIGINT, before)
            screen.finish()
    for line in summary.broken:
        say_broken(line)
    refused = take(options.out, lines, summary.everything)
    written = write_gradebook(options.out, exercise, summary.everything, books)
    for sentence in about_lateness(summary.results, books.lateness):
        print(sentence)
    code = conclude(summary, options.out, written)
    say_changes(options.out, summary.everything)
    return refused or code


def _regrade(
    options: argparse.Namespace,
    exercise: "Exercise",
    books: "GradebookOptions",
    lines: "Sequence[OverrideLine]",
) -> int:
    """Judge stored recordings again, and print whose marks changed. Return the exit code. This doesn't need ROS."""
    from workbook.grading.gradebook import write_gradebook
    from workbook.grading.regrade import regrade
    from workbook.grading.results_file import RESULTS, last_results
    from workbook.grading.roster import BadOption

    if not (options.out / RESULTS).is_file():
        raise BadOption(f"{options.out} has no {RESULTS}: grade first")
    code = conclude_regrading(regrade(options.out, exercise), exercise.stem)
    results = last_results(options.out / RESULTS, say_broken)
    code = take(options.out, lines, results) or code
    for path in write_gradebook(options.out, exercise, results, books):
        print(f"Written: {path}")
    ours = [result for result in results.values() if result.exercise == exercise.stem]
    for sentence in about_lateness(ours, books.lateness):
        print(sentence)
    say_changes(options.out, results)
    return code


def _repeat(
    options: argparse.Namespace, exercise: "Exercise", batch: "Batch", judges: "GradingBackend"
) -> int:
    """Judge all answers several times, and print the students whose verdict changes. Return the exit code."""
    from workbook.exercise.answers import Ungradable, read_answer
    from workbook.grading.judges import Job
    from workbook.grading.repeatability import unsteady
    from workbook.grading.roster import BadOption

    if options.repeat < 2:
        raise BadOption("--repeat must be at least 2")
    jobs = []
    for hand_in in batch.hand_ins(options.paths):
        try:
            if hand_in.problem is None:
                answer = read_answer(hand_in.path, exercise.stem)
                jobs.append(Job(hand_in.student, exercise.stem, answer, seed=options.seed))
        except Ungradable:
            continue
    return conclude_repetition(list(unsteady(jobs, options.repeat, judges)), len(jobs), options.repeat)
