"""`workbook grade`: judge a folder of answers and keep the gradebook."""

import argparse
import os
import signal
import sys
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbook.grading.batch import BatchSummary, Progress
    from workbook.grading.pool import Isolation

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
        nargs="+",
        type=Path,
        help="answers: s1042.py, s1042/any/where.py, .ipynb, or submitted/STUDENT/…",
    )
    parser.add_argument("--exercise", metavar="ID", help="the exercise (default: what the file names tell)")
    parser.add_argument("--out", metavar="DIR", required=True, type=Path, help="where the results go")
    parser.add_argument(
        "--slots", metavar="N", type=int, help=f"answers judged at once (default: {SLOTS_PER_CORE} per core)"
    )
    parser.add_argument(
        "--isolation",
        choices=["auto", "sandbox", "limits"],
        default="auto",
        help="sandbox (what auto wants): each program shut in by bubblewrap, with a network of its own. limits: own "
        "session, resource limits, own domain; only for answers that you would run yourself",
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
    """The best there is, or what was accepted. Raises NoSandbox when strangers' programs could not be shut in."""
    from workbook.observing.sandbox import NoSandbox, sandbox_problem

    if wanted == "limits":
        return "limits"
    problem = sandbox_problem()
    if problem is None:
        return "sandbox"
    raise NoSandbox(
        f"programs cannot be shut in on this machine: {problem}. If you would run these answers on your own machine "
        "anyway, say so with --isolation limits"
    )


def run(options: argparse.Namespace) -> int:
    from workbook.exercise.answers import Ungradable
    from workbook.exercise.course import NoCourse
    from workbook.exercise.definition import BrokenCriteria, load_exercise
    from workbook.exercise.source import SourceError, UnknownExercise
    from workbook.grading.batch import Batch
    from workbook.observing.sandbox import NoSandbox

    slots = SLOTS_PER_CORE * (os.cpu_count() or 1) if options.slots is None else options.slots
    stopping = _Stopping()
    screen = _Screen()
    before = signal.signal(signal.SIGINT, stopping)
    try:
        exercise = load_exercise(_exercise_name(options))
        if slots < 1:
            raise Ungradable("--slots must be at least 1")
        options.out.mkdir(parents=True, exist_ok=True)
        isolation = _isolation(options.isolation)
        warning = (
            "" if isolation == "sandbox" else " (grade only answers that you would run on your own machine)"
        )
        print(f"Grading {exercise.stem} on {slots} slots. Isolation: {isolation}{warning}.", file=sys.stderr)
        batch = Batch(exercise, options.out, slots, isolation)
        summary = batch.run(options.paths, screen.show, stop=lambda: stopping.wanted)
    except (Ungradable, UnknownExercise, NoCourse, BrokenCriteria, SourceError, NoSandbox, OSError) as error:
        print(f"workbook grade: {error}", file=sys.stderr)
        return 2
    finally:
        signal.signal(signal.SIGINT, before)
        screen.finish()
    return _conclude(summary, options.out)


def _conclude(summary: "BatchSummary", out: Path) -> int:
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
    print(f"{summary.judged} judged in {_minutes(summary.seconds)}, {summary.kept} kept from an earlier run.")
    print(f"Grades: {out / 'grades.csv'}   Everything: {out / 'results.jsonl'}")
    if summary.stopped:
        print("Stopped early. Run the same command again to go on.")
        return 130
    return 1 if counts["infra_error"] else 0
