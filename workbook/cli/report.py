"""`workbook report`: write an answer, its last recording, and the doctor's report to one file for an instructor."""

import argparse
from pathlib import Path

from workbook.cli import terminal
from workbook.cli.paths import as_typed, student_answers


def register(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "report",
        help="write a file to send to your instructor when you are stuck",
        description="Put your answer, the recording of its last check, and the doctor's report into one file. Home "
        "folders, your user name, and the machine's name are removed. Nothing is sent: you send the file yourself.",
    )
    parser.add_argument("exercise", metavar="EXERCISE", help="such as 09 or joint_positions")
    parser.add_argument(
        "--to", metavar="FILE", type=Path, help="where to write it (default: EXERCISE.report.json, here)"
    )
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Write the report. Return the exit code: 2 if there is no answer or the report can't be written, else 0."""
    from workbook.exercise.answers import Ungradable
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.exercise.source import UnknownExercise, find
    from workbook.grading.files import write_whole
    from workbook.lesson.help_report import help_report
    from workbook.lesson.last_recordings import last_recording

    try:
        stem = find(course_folder() / "solutions", options.exercise).stem
        folder = student_answers()
        file = folder / f"{stem}.py"
        if not file.is_file():
            raise Ungradable(f"there is no {as_typed(file)} yet, so there is nothing to report on")
        text = file.read_text(encoding="utf-8", errors="replace")
        last = last_recording(stem, folder)
        sha256 = _sha256(file, stem)
        path = options.to or Path(f"{stem}.report.json")
        write_whole(path, help_report(stem, text, sha256, last, doctor_lines()))
    except (Ungradable, UnknownExercise, NoCourse, OSError) as error:
        terminal.complain("report", error)
        return 2
    print(f"Written: {as_typed(path)}")
    if last is None:
        terminal.say(
            f"It contains no recording. To add one, run `workbook check {stem[:2]}`, and then this command "
            "again."
        )
    elif last.answer_sha256 != sha256:
        terminal.say(
            f"Its recording shows an earlier version. To update it, run `workbook check {stem[:2]}`, and then this "
            "command again."
        )
    terminal.say("It's plain text. Read it before you send it to the person who helps you.")
    return 0


def _sha256(file: Path, stem: str) -> str:
    """Return the answer's hash, or "" if the answer can't be judged. A report may contain such an answer, too."""
    from workbook.exercise.answers import Ungradable, read_answer

    try:
        return read_answer(file, stem).sha256
    except Ungradable:
        return ""


def doctor_lines() -> tuple[str, ...]:
    """Return the doctor's findings, one per line.

    The lines aren't wrapped, because names can't be removed from a path that is split between two lines.
    """
    from workbook.lab.health import examine

    return tuple(f"{one.status:<5} {one.title}: {one.saw} {one.todo}".rstrip() for one in examine())
