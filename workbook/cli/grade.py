"""`workbook grade`: judge a folder of answers and keep the gradebook."""

import argparse
import os
import signal
import sys
from collections.abc import Sequence
from contextlib import AbstractContextManager, nullcontext
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

    from workbook.exercise.definition import Exercise
    from workbook.grading.batch import Batch, BatchSummary, Progress
    from workbook.grading.books import Lateness
    from workbook.grading.pool import Isolation, Judges
    from workbook.grading.results import Result

SLOTS_PER_CORE = 4


def register(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    parser = subparsers.add_parser(
        "grade",
        help="judge a folder of answers",
        description="Judge every answer below PATH and write results.jsonl (one line per attempt) and grades.csv to "
        "DIR. A run that was stopped or killed goes on where it was; unchanged answers are not run again.",
    )
    parser.add_argument(
        "paths",
        metavar="PATH",
        nargs="*",
        type=Path,
        help="answers: s1042.py, s1042/any/where.py, .ipynb, or submitted/STUDENT/…",
    )
    parser.add_argument("--exercise", metavar="ID", help="the exercise (default: what the file names tell)")
    parser.add_argument("--out", metavar="DIR", required=True, type=Path, help="where the results go")
    parser.add_argument(
        "--slots", metavar="N", type=int, help=f"answers judged at once (default: {SLOTS_PER_CORE} per core)"
    )
    parser.add_argument(
        "--farm",
        metavar="ADDRESS",
        help="judge on other machines: the dask scheduler at tcp://host:8786 (see 'A farm' in environment.md)",
    )
    parser.add_argument(
        "--isolation",
        choices=["auto", "sandbox", "uid", "landlock", "limits"],
        default="auto",
        help="sandbox (what auto wants): each program shut in by bubblewrap, with a network of its own. uid: a user id "
        "of its own, where the grader is root. landlock: the kernel hides files. limits: resource limits and own "
        "domain; only for answers that you would run yourself",
    )
    parser.add_argument(
        "--format",
        metavar="LIST",
        default="",
        help="further forms of the gradebook, separated by commas: html (a page for each student, and one for the "
        "class), gradescope, canvas, moodle, nbgrader",
    )
    parser.add_argument(
        "--column", metavar="NAME", help='what Canvas or Moodle call the exercise: "Exercise 09 (12345)"'
    )
    parser.add_argument(
        "--regrade",
        action="store_true",
        help="run nothing: judge the stored recordings again under the criteria as they are now",
    )
    parser.add_argument(
        "--criteria",
        metavar="FOLDER",
        type=Path,
        help="your own hidden criteria, NN_slug.py, in a folder outside of the course",
    )
    parser.add_argument(
        "--aliases",
        metavar="CSV",
        type=Path,
        help="lines of `file or folder,student`: who a hand-in belongs to",
    )
    parser.add_argument(
        "--assignment",
        metavar="NAME",
        help="what nbgrader calls the exercise: looks at submitted/STUDENT/NAME/ only",
    )
    parser.add_argument("--deadline", metavar="DATE", help="when it was due: 2026-05-31T23:59+02:00")
    parser.add_argument(
        "--late-per-day",
        metavar="SHARE",
        type=float,
        default=0.0,
        help="share of the points that each day, begun or whole, after the deadline costs: 0.1",
    )
    parser.add_argument(
        "--repeat",
        metavar="N",
        type=int,
        help="judge each answer N times and name those whose verdict changes; the gradebook is left alone",
    )
    parser.set_defaults(run=run)


def _minutes(seconds: float) -> str:
    whole = round(seconds)
    return f"{whole // 60}:{whole % 60:02d} min" if whole >= 60 else f"{whole} s"


def _outcome(result: dict[str, object]) -> str:
    if result["status"] != "graded":
        return f"{result['status']}: {result['reason']}"
    return f"{result['score']:g}/{result['max_score']:g}"


def _printable(text: object) -> str:
    return "".join(character if character.isprintable() else "?" for character in str(text))


class _Screen:
    """Progress on one line of a terminal, or a line per answer in a file."""

    def __init__(self) -> None:
        self._is_terminal = sys.stderr.isatty()

    def show(self, progress: "Progress") -> None:
        left = "" if progress.left_s is None else f", {_minutes(progress.left_s)} left"
        rate = f"{progress.per_minute:.0f} per minute{left}"
        latest = ""
        if progress.latest is not None:
            latest = _printable(f"{progress.latest['student']} {_outcome(progress.latest)}")
        line = f"[{progress.done}/{progress.total}] {rate}  {latest}"
        if self._is_terminal:
            width = os.get_terminal_size(sys.stderr.fileno()).columns
            print(f"\r\x1b[K{line[: width - 1]}", end="", file=sys.stderr, flush=True)
        else:
            print(line, file=sys.stderr, flush=True)

    def say(self, text: str) -> None:
        """A sentence on a line of its own."""
        start = "\r\x1b[K" if self._is_terminal else ""
        print(start + _printable(text), file=sys.stderr, flush=True)

    def finish(self) -> None:
        if self._is_terminal:
            print(file=sys.stderr)


class _Stopping:
    """Ctrl-C once: finish the answers under way. Twice: stop at once (nothing judged is lost)."""

    def __init__(self) -> None:
        self.wanted = False

    def __call__(self, *_: object) -> None:
        if self.wanted:
            os._exit(130)
        self.wanted = True
        print(
            "\nStopping after the answers under way. Ctrl-C again stops at once; run the same command to go on.",
            file=sys.stderr,
            flush=True,
        )


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
    raise Ungradable("the file names do not tell which exercise this is. Name it with --exercise")


def _isolation(wanted: str) -> "Isolation":
    """The sandbox, or the weaker tier that was accepted by its name. Raises NoSandbox when it does not work here."""
    from workbook.grading.tier_check import best_below_sandbox, tier_problem
    from workbook.observing.sandbox import NoSandbox
    from workbook.observing.tiers import BEST_FIRST, covers, leaves_open, named_tier

    isolation: Isolation = BEST_FIRST[0] if wanted == "auto" else named_tier(wanted)
    problem = tier_problem(isolation)
    if problem is None:
        return isolation
    if isolation == "sandbox":
        best = best_below_sandbox()
        raise NoSandbox(
            f"programs cannot be shut in on this machine: {problem}. The best that works here is {best}: "
            f"{covers(best)}. {leaves_open(best)} If that will do for these answers, say so with --isolation {best}"
        )
    raise NoSandbox(f"--isolation {isolation} does not work on this machine: {problem}")


@dataclass(frozen=True)
class _Books:
    """What to make of the results besides grades.csv."""

    formats: tuple[str, ...]
    lateness: "Lateness | None"
    column: str | None
    assignment: str | None


def _books(options: argparse.Namespace) -> _Books:
    """Raises BadOption."""
    from workbook.grading.books import BadOption, Lateness, parse_moment
    from workbook.grading.exports import FORMATS

    formats = tuple(filter(None, (name.strip().lower() for name in options.format.split(","))))
    for name in formats:
        if name not in FORMATS:
            raise BadOption(f"--format {name}: there are {', '.join(FORMATS)}")
    lateness = None
    if options.deadline is not None:
        deadline = parse_moment(options.deadline)
        if deadline is None:
            raise BadOption(f"--deadline {options.deadline}: write it as 2026-05-31T23:59+02:00")
        if not 0.0 < options.late_per_day <= 1.0:
            raise BadOption("--deadline needs --late-per-day with a share above 0 and at most 1, such as 0.1")
        lateness = Lateness(deadline, options.late_per_day)
    elif options.late_per_day:
        raise BadOption("--late-per-day needs --deadline")
    if options.assignment is not None and Path(options.assignment).name != options.assignment:
        raise BadOption(f"--assignment {options.assignment}: it is the name of a folder, without any /")
    return _Books(formats, lateness, options.column, options.assignment)


def run(options: argparse.Namespace) -> int:
    from workbook.exercise.answers import Ungradable
    from workbook.exercise.course import NoCourse
    from workbook.exercise.definition import OWN_CRITERIA, BrokenCriteria, load_exercise
    from workbook.exercise.source import SourceError, UnknownExercise
    from workbook.grading.books import BadOption
    from workbook.grading.pool import NoJudges
    from workbook.observing.sandbox import NoSandbox

    try:
        books = _books(options)
        if options.criteria is not None:
            if not options.criteria.is_dir():
                raise BadOption(f"--criteria {options.criteria}: there is no such folder")
            os.environ[OWN_CRITERIA] = str(options.criteria.resolve())
        if options.regrade and not options.exercise:
            raise BadOption("--regrade needs --exercise: it looks at results, not at files")
        if not options.regrade and not options.paths:
            raise BadOption("name a folder or files with answers")
        exercise = load_exercise(_exercise_name(options))
        if options.regrade:
            return _regrade(options, exercise, books)
        return _grade(options, exercise, books)
    except (
        BadOption,
        Ungradable,
        UnknownExercise,
        NoCourse,
        BrokenCriteria,
        SourceError,
        NoSandbox,
        NoJudges,
        OSError,
    ) as error:
        print(f"workbook grade: {error}", file=sys.stderr)
        return 2


def _judges(options: argparse.Namespace, stem: str, screen: _Screen) -> "AbstractContextManager[Judges]":
    """Who judges: slots of this machine, or a farm. Says who. Raises BadOption, NoSandbox, NoJudges."""
    from workbook.grading.books import BadOption
    from workbook.grading.pool import LocalSlots

    if options.farm is not None:
        return _farm(options, stem, screen)
    slots = SLOTS_PER_CORE * (os.cpu_count() or 1) if options.slots is None else options.slots
    if slots < 1:
        raise BadOption("--slots must be at least 1")
    isolation = _isolation(options.isolation)
    screen.say(f"Grading {stem} on {slots} slots. Isolation: {isolation}{_warning(isolation)}.")
    return nullcontext(LocalSlots(slots, isolation))


def _farm(options: argparse.Namespace, stem: str, screen: _Screen) -> "AbstractContextManager[Judges]":
    """Each worker tries itself what it can do: this machine runs no answer."""
    from workbook.grading.books import BadOption
    from workbook.grading.farm import Farm, check_address

    if options.slots is not None:
        raise BadOption(
            "--slots is for this machine. On a farm each worker says it: dask worker --nthreads 16"
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
    from workbook.observing.tiers import covers, leaves_open

    return "" if isolation == "sandbox" else f": {covers(isolation)}. {leaves_open(isolation).rstrip('.')}"


def _grade(options: argparse.Namespace, exercise: "Exercise", books: _Books) -> int:
    from workbook.grading.batch import Batch
    from workbook.grading.books import read_aliases

    aliases = read_aliases(options.aliases) if options.aliases else None
    screen = _Screen()
    with _judges(options, exercise.stem, screen) as judges:
        options.out.mkdir(parents=True, exist_ok=True)
        batch = Batch(exercise, options.out, aliases=aliases, assignment=books.assignment, judges=judges)
        if options.repeat is not None:
            return _repeat(options, exercise, batch, judges)
        stopping = _Stopping()
        before = signal.signal(signal.SIGINT, stopping)
        try:
            summary = batch.run(options.paths, screen.show, stop=lambda: stopping.wanted)
        finally:
            signal.signal(signal.SIGINT, before)
            screen.finish()
    written = _write(options.out, exercise, books, summary.everything)
    for line in _about_lateness(summary.results, books.lateness):
        print(line)
    return _conclude(summary, options.out, written)


def _write(
    out: Path, exercise: "Exercise", books: _Books, results: "Mapping[tuple[str, str], Result]"
) -> "list[Path]":
    from workbook.grading.books import write_books

    return write_books(
        out,
        exercise,
        results,
        books.formats,
        lateness=books.lateness,
        column=books.column,
        assignment=books.assignment,
    )


def _regrade(options: argparse.Namespace, exercise: "Exercise", books: _Books) -> int:
    """Judge stored recordings again and tell whose marks changed."""
    from workbook.grading.again import regrade
    from workbook.grading.books import BadOption
    from workbook.grading.results import RESULTS, last_results

    if not (options.out / RESULTS).is_file():
        raise BadOption(f"{options.out} holds no {RESULTS}: grade first")
    found = regrade(options.out, exercise)
    changed = [one for one in found if one.changed]
    troubled = [one for one in found if one.problem]
    print(f"{len(found)} recordings of {exercise.stem} judged again; the marks of {len(changed)} changed.")
    for one in changed:
        print(f"  {_printable(one.student)}: {one.before:g} → {one.after:g}")
    for one in troubled:
        print(f"  {_printable(one.student)}: not judged again: {_printable(one.problem)}")
    results = last_results(options.out / RESULTS)
    for path in _write(options.out, exercise, books, results):
        print(f"Written: {path}")
    ours = [result for result in results.values() if result["exercise"] == exercise.stem]
    for line in _about_lateness(ours, books.lateness):
        print(line)
    return 1 if troubled else 0


def _repeat(options: argparse.Namespace, exercise: "Exercise", batch: "Batch", judges: "Judges") -> int:
    """Judge everything several times and name the answers whose verdict changes."""
    from workbook.exercise.answers import Ungradable, read_answer
    from workbook.grading.again import unsteady
    from workbook.grading.books import BadOption
    from workbook.grading.pool import Job

    if options.repeat < 2:
        raise BadOption("--repeat must be at least 2")
    jobs = []
    for hand_in in batch.hand_ins(options.paths):
        try:
            if hand_in.problem is None:
                jobs.append(Job(hand_in.student, exercise.stem, read_answer(hand_in.path, exercise.stem)))
        except Ungradable:
            continue
    found = list(unsteady(jobs, options.repeat, judges))
    print(f"{len(jobs)} answers, each judged {options.repeat} times: {len(found)} with changing verdicts.")
    for one in found:
        print(f"  {_printable(one.student)}:")
        for verdict, times in one.verdicts:
            print(f"    {times} × {_printable(verdict)}")
    return 1 if found else 0


def _about_tries(results: "Sequence[Result]") -> list[str]:
    """How many answers were tried twice, and by name those whose tries differ."""
    from workbook.grading.results import tried_twice, tries_differ

    twice = [result for result in results if result.get("tries")]
    if not twice:
        return []
    differ = [result for result in twice if tries_differ(result)]
    what = "answer was" if len(twice) == 1 else "answers were"
    lines = [
        f"{len(twice)} {what} tried twice, because the first try was inconclusive; {len(differ)} differ. "
        "Both tries are kept."
    ]
    return lines + [f"  {_printable(one['student'])}: {_printable(tried_twice(one))}" for one in differ]


def _about_lateness(results: "Sequence[Result]", lateness: "Lateness | None") -> list[str]:
    """Whose lateness nobody can tell, where it counts."""
    unknown = [] if lateness is None else lateness.unknown(results)
    if not unknown:
        return []
    names = ", ".join(_printable(one["student"]) for one in unknown[:5]) + (", …" if len(unknown) > 5 else "")
    return [
        f"Nothing was taken off for lateness where no timestamp.txt told when it was handed in: {len(unknown)} of "
        f"{len(results)} ({names})."
    ]


def _conclude(summary: "BatchSummary", out: Path, written: "list[Path]") -> int:
    counts = {"graded": 0, "ungradable": 0, "infra_error": 0}
    full = 0
    for result in summary.results:
        counts[result["status"]] += 1
        full += result["score"] is not None and result["score"] == result["max_score"]
    print(
        f"{len(summary.results)} answers: {counts['graded']} graded ({full} with full marks), "
        f"{counts['ungradable']} ungradable, {counts['infra_error']} not judged through a fault of the grader."
    )
    for result in summary.results:
        if result["status"] != "graded":
            print(f"  {_printable(result['student'])}: {_printable(_outcome(result))}")
    for line in _about_tries(summary.results):
        print(line)
    print(f"{summary.judged} judged in {_minutes(summary.seconds)}, {summary.kept} kept from an earlier run.")
    print(f"Everything: {out / 'results.jsonl'}   Made from it: {', '.join(map(str, written))}")
    if summary.stopped:
        print("Stopped early. Run the same command again to go on.")
        return 130
    return 1 if counts["infra_error"] else 0
