"""`workbook autograde`: judge a submission inside another grading system, and report the result in its format."""

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from workbook.cli.grade_screen import printable

if TYPE_CHECKING:
    from workbook.exercise.definition import Exercise
    from workbook.grading.github import Pushed
    from workbook.grading.results import Result

JUDGED, NOT_YET, FAULT = 0, 1, 2


def register(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand, with an action for each grading system."""
    parser = subparsers.add_parser(
        "autograde",
        help="judge one submission on Gradescope or GitHub (the autograders from `workbook package` call this)",
        description="Judge one submission, in the folder where another system has put it.",
    )
    places = parser.add_subparsers(title="places", metavar="PLACE", required=True)
    isolation = argparse.ArgumentParser(add_help=False)
    isolation.add_argument(
        "--isolation",
        choices=["auto", "sandbox", "uid", "landlock", "limits"],
        default="auto",
        help="auto: the strongest isolation that works here; the result names it",
    )
    scope = places.add_parser(
        "gradescope", parents=[isolation], help="write results.json. Exit code 0: judged"
    )
    scope.add_argument("exercise", metavar="EXERCISE")
    scope.add_argument("--submission", metavar="FOLDER", required=True, type=Path)
    scope.add_argument("--results", metavar="FILE", required=True, type=Path)
    scope.set_defaults(run=run_gradescope)
    github = places.add_parser(
        "github",
        parents=[isolation],
        help="write a summary. Exit code 0: every answer is correct, 1: not yet, or nothing was handed in, 2: an "
        "error in the judge",
    )
    github.add_argument("exercises", metavar="EXERCISE", nargs="+")
    github.add_argument("--answers", metavar="FOLDER", required=True, type=Path)
    github.add_argument("--out", metavar="FOLDER", required=True, type=Path)
    github.add_argument("--summary", metavar="FILE", type=Path, help="Markdown is appended to it")
    github.add_argument(
        "--outputs", metavar="FILE", type=Path, help="lines of name=value are appended to it, for Classroom"
    )
    github.set_defaults(run=run_github)


def run_gradescope(options: argparse.Namespace) -> int:
    """Judge a submission for Gradescope, and return the exit code. Write results.json even if the judge fails."""
    from workbook.exercise.definition import load_exercise
    from workbook.grading.files import write_whole
    from workbook.grading.gradescope import fault_json, grade_submission

    try:
        exercise = load_exercise(options.exercise)
        result = grade_submission(exercise, options.submission, options.results, options.isolation)
    except Exception as error:  # any exception here is our fault, so it must not cost the student points
        print(printable(f"workbook autograde: {type(error).__name__}: {error}"), file=sys.stderr)
        write_whole(options.results, fault_json(f"{type(error).__name__}: {error}"))
        return FAULT
    print(_line(result))
    return FAULT if result.status == "infra_error" else JUDGED


def _line(result: "Result") -> str:
    """Return a result as one line of printable characters.

    Students choose file names, and GitHub runs a log line that begins with `::` as a command. So line breaks must not
    get into the log.
    """
    said = result.reason if result.score is None else f"{result.score:g} of {result.max_score:g} points"
    return printable(f"{result.exercise}: {result.status}, {said}. Isolation: {result.isolation}.")


def run_github(options: argparse.Namespace) -> int:
    """Judge all exercises in a class repository. Write the summary, the results, and the outputs for GitHub Classroom.

    Return the exit code.
    """
    from workbook.exercise.definition import load_exercise
    from workbook.grading.github import all_hold, grade_pushed, summary
    from workbook.grading.single import choose_isolation

    exercises: list[Exercise] = []
    try:
        exercises = [load_exercise(name) for name in options.exercises]
        isolation = choose_isolation(options.isolation)
        pushed = grade_pushed(exercises, options.answers, options.out, isolation)
        text = summary(pushed, options.out, isolation)
    except Exception as error:
        print(printable(f"workbook autograde: {type(error).__name__}: {error}"), file=sys.stderr)
        _append(options.summary, _fault_page(error))
        _append(options.outputs, _faults(exercises))
        return FAULT
    for one in pushed:
        print(f"{one.exercise.stem}: nothing handed in" if one.result is None else _line(one.result))
    _append(options.summary, text)
    _append(options.outputs, _outputs(pushed, options.out))
    if any(one.result is not None and one.result.status == "infra_error" for one in pushed):
        return FAULT
    return JUDGED if all_hold(pushed) else NOT_YET


def _append(path: Path | None, text: str) -> None:
    if path is not None:
        with path.open("a", encoding="utf-8", errors="replace") as file:
            file.write(text)


def _outputs(pushed: "Sequence[Pushed]", out: Path) -> str:
    """Store the results under `out`, and return GitHub Classroom's results as lines of the form name=value."""
    from workbook.grading.files import write_whole
    from workbook.grading.github import classroom, encoded
    from workbook.grading.results_file import RESULTS, ResultsFile

    book = ResultsFile(out / RESULTS)
    lines = []
    for one in pushed:
        if one.result is not None:
            book.append(one.result)
        for name, result in classroom(one).items():
            write_whole(out / "classroom" / f"{name}.json", json.dumps(result, indent=1) + "\n")
            lines.append(f"{name}={encoded(result)}\n")
    book.close()
    return "".join(lines)


def _faults(exercises: "Sequence[Exercise]") -> str:
    from workbook.grading.github import encoded, not_run, runners

    return "".join(
        f"{name}={encoded(not_run(criterion))}\n"
        for exercise in exercises
        for name, criterion in runners(exercise).items()
    )


def _fault_page(error: Exception) -> str:
    from workbook.feedback.markdown import plain

    return (
        "## Not judged\n\nThe judge itself failed, not your program: "
        f"{plain(str(error))}\n\nTell your instructor. No points are lost.\n"
    )
