"""`workbook check`: judge one answer in the terminal, as `%check` does in a notebook."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbook.exercise.answers import Answer
    from workbook.exercise.definition import Exercise
    from workbook.exercise.early_start import StartedAnswer
    from workbook.exercise.judgement import Judgement

FULL_MARKS, NOT_YET, NOT_JUDGED = 0, 1, 2


def register(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "check",
        help="judge your answer to an exercise",
        description="Run an answer, watch what it does on the topics, and say what passes and what does not yet. "
        "Exit code 0: full marks, 1: not yet, 2: could not be judged.",
    )
    parser.add_argument("exercise", metavar="EXERCISE", help="such as 09_joint_positions or joint_positions")
    parser.add_argument(
        "file",
        metavar="FILE",
        nargs="?",
        type=Path,
        help="the answer, .py or .ipynb (default: answers/EXERCISE.py)",
    )
    parser.add_argument(
        "--as-graded",
        action="store_true",
        help="also keep a passing program running for 8 real seconds, as the instructor's grader does",
    )
    parser.add_argument("--review", action="store_true", help="with full marks: print a prompt for a review")
    parser.set_defaults(run=run)


def _default_file(stem: str) -> Path | None:
    for folder in (Path("answers"), Path("work/answers"), Path("../answers")):
        candidate = folder / f"{stem}.py"
        if candidate.is_file():
            return candidate
    return None


def run(options: argparse.Namespace) -> int:
    """Start the answer, then import the judge, then judge."""
    from workbook.exercise.answers import Ungradable, read_answer
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.exercise.early_start import StartedAnswer
    from workbook.exercise.source import SourceError, UnknownExercise, find, load
    from workbook.ros.domains import NoDomainFree

    try:
        source = load(find(course_folder() / "solutions", options.exercise))
        file = options.file or _default_file(source.stem)
        if file is None:
            raise Ungradable(
                f"there is no answers/{source.stem}.py here; name the file: workbook check EXERCISE FILE"
            )
        answer = read_answer(file, source.stem)
        with StartedAnswer(source, answer) as started:
            return _judge(options, source.stem, file, answer, started)
    except (Ungradable, UnknownExercise, NoCourse, SourceError, NoDomainFree, OSError) as error:
        return _not_judged(error)


def _not_judged(error: Exception) -> int:
    print(f"workbook check: {error}", file=sys.stderr)
    return NOT_JUDGED


def _judge(
    options: argparse.Namespace, stem: str, file: Path, answer: "Answer", started: "StartedAnswer"
) -> int:
    """Judge an answer that runs already. What needs ROS is imported here, while the answer imports it as well."""
    from workbook.exercise.definition import BrokenCriteria, load_exercise
    from workbook.feedback import wording
    from workbook.feedback.review import review_prompt
    from workbook.feedback.text import as_text

    try:
        exercise = load_exercise(stem)
    except BrokenCriteria as error:
        return _not_judged(error)
    judgement = _judgement_of(exercise, answer, started, thorough=options.as_graded)
    print(as_text(judgement, sys.stdout.isatty(), exhibit=wording.exhibit_of(judgement)))
    if judgement.status != "graded":
        return NOT_JUDGED
    if wording.all_shown_hold(judgement):
        print(f"  Hand in this file: {file}")
        if options.review:
            print("\n" + review_prompt(exercise.source, answer.text, judgement))
        return FULL_MARKS
    return NOT_YET


def _judgement_of(
    exercise: "Exercise", answer: "Answer", started: "StartedAnswer", *, thorough: bool
) -> "Judgement":
    """Judge the started program; one more try, if that is inconclusive, starts it anew."""
    from workbook.exercise.judging import Judge
    from workbook.grading.retries import until_sure
    from workbook.watching.observer import Observer

    with Observer(started.lease) as observer:
        judge = Judge(observer)
        running = [started]

        def once() -> "Judgement":
            return judge.judge(
                exercise,
                answer,
                thorough=thorough,
                report=_report,
                started=running.pop() if running else None,
            )

        return until_sure(once, _report)


def _report(judgement: "Judgement") -> None:
    """Say what is still under way."""
    from workbook.feedback import wording

    if judgement.doubt:
        print(wording.provisional_line(judgement), file=sys.stderr)
    elif judgement.provisional:
        print("Judging it on the wall clock as well; that takes some seconds ...", file=sys.stderr)
    else:
        print("Judged on robot time; checking that it keeps running ...", file=sys.stderr)
