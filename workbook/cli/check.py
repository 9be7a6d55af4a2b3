"""`workbook check`: judge one answer in the terminal, as `%check` does in a notebook."""

import argparse
import sys
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from workbook.cli import terminal
from workbook.cli.paths import as_typed, student_answers
from workbook.cli.verdict_text import FULL_MARKS, NOT_JUDGED, NOT_YET, verdict_text

if TYPE_CHECKING:
    from workbook.exercise.answers import Answer
    from workbook.exercise.definition import Exercise
    from workbook.exercise.early_start import StartedAnswer
    from workbook.exercise.judgement import Judgement
    from workbook.exercise.source import ExerciseSource


def register(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "check",
        help="judge your answer to an exercise",
        description="Run an answer, watch its effects on the topics, and report which criteria pass. Exit code 0: "
        "full marks, 1: not yet, 2: could not be judged.",
    )
    parser.add_argument("exercise", metavar="EXERCISE", help="such as 09 or joint_positions")
    parser.add_argument(
        "file",
        metavar="FILE",
        nargs="?",
        type=Path,
        help="the answer, .py or .ipynb (default: work/answers/EXERCISE.py)",
    )
    parser.add_argument(
        "--watch", action="store_true", help="judge again each time the file is saved, until Ctrl-C"
    )
    parser.add_argument(
        "--as-graded",
        action="store_true",
        help="also start the program again for 8 real seconds, as `workbook grade` does",
    )
    parser.add_argument(
        "--seed",
        metavar="N",
        type=int,
        help="seed of the random values that the judge sends (default: a new one each time)",
    )
    parser.add_argument(
        "--review", action="store_true", help="also print a prompt for a colleague or an AI assistant"
    )
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Judge the answer, and return the exit code.

    The answer starts before the judge is imported, so that both load in parallel.
    """
    from workbook.exercise.answers import Ungradable, read_answer
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.exercise.early_start import StartedAnswer
    from workbook.exercise.source import SourceError, UnknownExercise, find, load
    from workbook.ros.domains import NoDomainFree

    try:
        source = load(find(course_folder() / "solutions", options.exercise))
        file = _file(options, source)
        if options.watch:
            return _watch(options, source, file)
        answer = read_answer(file, source.stem)
        with StartedAnswer(source, answer) as started:
            return _judge(options, source.stem, file, answer, started)
    except BrokenPipeError:
        raise
    except (Ungradable, UnknownExercise, NoCourse, SourceError, NoDomainFree, OSError) as error:
        return _not_judged(error)


def _file(options: argparse.Namespace, source: "ExerciseSource") -> Path:
    """Return the path of the answer to judge.

    If there is no answer yet, create it from the starter with --watch, and raise Ungradable otherwise.
    """
    from workbook.exercise.answer_files import save_answer
    from workbook.exercise.answers import Ungradable

    named = Path(options.exercise)
    if options.file is not None:
        return Path(options.file)
    if named.suffix in (".py", ".ipynb") and named.is_file():
        return named
    file = student_answers() / f"{source.stem}.py"
    if not file.is_file():
        if not options.watch:
            raise Ungradable(
                f"there is no {as_typed(file)} yet. Run the answer cell in the exercise's notebook, let `workbook "
                f"check {source.stem[:2]} --watch` create the file from the starter, or name your file: `workbook "
                f"check {source.stem[:2]} FILE`"
            )
        save_answer(source.stem, source.starter_code, source.starter_code)
    return file


def _watch(options: argparse.Namespace, source: "ExerciseSource", file: Path) -> int:
    from workbook.cli.watch.mode import Watched, WatchMode
    from workbook.cli.watch.screen import WatchScreen

    def note(judgement: "Judgement", answer: "Answer") -> None:
        _note(judgement, answer, file)

    return WatchMode(Watched(source, file, options.as_graded, note, options.seed), WatchScreen()).run()


def _note(judgement: "Judgement", answer: "Answer", file: Path) -> None:
    """Store the judgment in the student's progress, as `%check` does.

    Do nothing if the file isn't in the student's answers folder.
    """
    from workbook.lesson.best_answers import Check

    if file.resolve().parent == student_answers().resolve():
        with suppress(OSError):  # on a full disk, the student should still see the verdict
            Check(judgement.stem, answer.text).note(judgement)


def _not_judged(error: Exception) -> int:
    terminal.complain("check", error)
    return NOT_JUDGED


def _judge(
    options: argparse.Namespace, stem: str, file: Path, answer: "Answer", started: "StartedAnswer"
) -> int:
    """Judge an answer that has already been started, and return the exit code.

    Modules that need ROS are imported here, while the answer is loading.
    """
    from workbook.exercise.definition import BrokenCriteria, load_exercise
    from workbook.feedback import wording
    from workbook.feedback.review import review_prompt

    try:
        exercise = load_exercise(stem)
    except BrokenCriteria as error:
        return _not_judged(error)
    judgement = _judgement_of(exercise, answer, started, soak=options.as_graded, seed=options.seed)
    print(verdict_text(judgement, terminal.in_color(sys.stdout)))
    _note(judgement, answer, file)
    if judgement.status != "graded":
        return NOT_JUDGED
    done = wording.all_shown_hold(judgement)
    if done:
        print(f"  Hand in this file: {as_typed(file)}")
    if options.review:
        print("\n" + review_prompt(exercise.source, answer.text, judgement))
    return FULL_MARKS if done else NOT_YET


def _judgement_of(
    exercise: "Exercise", answer: "Answer", started: "StartedAnswer", *, soak: bool, seed: int | None
) -> "Judgement":
    """Judge the program that has been started.

    If the judgment is inconclusive, start the program again for another try.
    """
    from workbook.exercise.judging import Judge
    from workbook.exercise.retries import until_sure
    from workbook.watching.observer import Observer

    with Observer(started.lease) as observer:
        judge = Judge(observer)
        running = [started]

        def once() -> "Judgement":
            return judge.judge(
                exercise,
                answer,
                soak=soak,
                report=_report,
                started=running.pop() if running else None,
                seed=seed,
            )

        return until_sure(once, _report)


def _report(judgement: "Judgement") -> None:
    """Print the judge's next step after a provisional or inconclusive judgment."""
    from workbook.feedback import wording

    if judgement.inconclusive_reason:
        terminal.say(wording.provisional_line(judgement), sys.stderr)
    elif judgement.provisional:
        print("Judging it on the wall clock, too. This takes a few seconds ...", file=sys.stderr)
    else:
        print("Judged once. Now watching it in real time, too ...", file=sys.stderr)
