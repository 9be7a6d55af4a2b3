"""`workbook replay`: show the contents of a report that a student has sent, without running any of its code."""

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from workbook.cli import terminal

if TYPE_CHECKING:
    from workbook.lesson.replay import ReportReplay


def register(subparsers: "argparse._SubParsersAction[argparse.ArgumentParser]") -> None:
    """Add the subcommand."""
    parser = subparsers.add_parser(
        "replay",
        help="show the contents of a report that a student has sent",
        description="Show the answer, the judgment of its recording, the messages, and the doctor's report. Nothing "
        "in the report is executed.",
    )
    parser.add_argument("file", metavar="FILE", type=Path, help="a file written by `workbook report`")
    parser.add_argument("--html", metavar="FILE", type=Path, help="also write a page with the timeline")
    parser.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Show the report. Return the exit code: 2 if it can't be read or judged, else 0."""
    from workbook.exercise.course import NoCourse, course_folder
    from workbook.exercise.definition import BrokenCriteria, load_exercise
    from workbook.exercise.source import SourceError, stems
    from workbook.grading.files import write_whole
    from workbook.lesson.help_report import NoReport, read_report
    from workbook.lesson.replay import replay, replay_page

    try:
        report = read_report(options.file, stems(course_folder() / "solutions"))
        exercise = load_exercise(report.exercise)
        shown = replay(report, exercise)
        _say(shown)
        if options.html is not None:
            print(f"Written: {write_whole(options.html, replay_page(shown, exercise))}")
    except BrokenPipeError:
        raise
    except (NoReport, NoCourse, BrokenCriteria, SourceError, OSError) as error:
        terminal.complain("replay", error)
        return 2
    return 0


def _say(shown: "ReportReplay") -> None:
    from workbook.cli.verdict_text import verdict_text
    from workbook.recording.plain_text import without_commands

    print(f"A report on {shown.report.exercise}.")
    for note in shown.notes():
        terminal.say(note)
    if shown.judgement is not None:
        print(f"\n{verdict_text(shown.judgement, terminal.in_color(sys.stdout))}")
    sections = (
        ("What happened", shown.happened()),
        ("The answer", shown.report.answer.splitlines()),
        ("The doctor's report", shown.report.doctor),
    )
    for heading, lines in sections:
        print(f"\n{heading}:")
        for line in lines:
            print(f"  {without_commands(line)}")
