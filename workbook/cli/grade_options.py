"""Define and interpret the options of `workbook grade`."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from workbook.grading.gradebook import GradebookOptions
    from workbook.grading.lateness import Lateness
    from workbook.grading.roster import Roster

SLOTS_PER_CORE = {"simulated": 2, "wall": 4}
"""The number of answers that run in parallel per core, for each clock.

On the wall clock, more answers can run, because they spend nine tenths of the time waiting.
"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add all options, in the order of `--help`."""
    _add_answers(parser)
    _add_judges(parser)
    _add_retries(parser)
    _add_gradebook(parser)
    _add_appeals(parser)
    _add_criteria(parser)
    _add_hand_ins(parser)
    _add_lateness(parser)
    _add_repetition(parser)


def _add_answers(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "paths",
        metavar="PATH",
        nargs="*",
        type=Path,
        help="answers: s1042.py, s1042/any/where.py, .ipynb, or submitted/STUDENT/…",
    )
    parser.add_argument("--exercise", metavar="ID", help="the exercise (default: taken from the file names)")
    parser.add_argument("--out", metavar="DIR", required=True, type=Path, help="where the results go")


def _add_judges(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--slots",
        metavar="N",
        type=int,
        help=f"answers judged in parallel (default: {SLOTS_PER_CORE['simulated']} per core in simulated time, "
        f"{SLOTS_PER_CORE['wall']} per core on the wall clock, and more while processors are idle). Answers that are "
        "only watched in real time don't count. With uid and landlock, the default is 1",
    )
    parser.add_argument(
        "--farm",
        metavar="ADDRESS",
        help="judge on other machines: the dask scheduler at tcp://host:8786 (see 'A farm' in exercises/README.md)",
    )
    parser.add_argument(
        "--isolation",
        choices=["auto", "sandbox", "uid", "landlock", "limits"],
        default="auto",
        help="With sandbox (auto means the same), each program runs in a bubblewrap sandbox, with its own network. "
        "With uid, it has a separate user id, if you are root. With landlock, the kernel hides files. With "
        "limits, it has resource limits and its own domain: only for answers that you would run yourself",
    )
    parser.add_argument(
        "--seed",
        metavar="N",
        type=int,
        help="seed of the random values that the judge sends to each answer (default: a new one each time)",
    )


def _add_retries(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--retry-stopped",
        action="store_true",
        help="rejudge answers that stopped the judge twice (ungradable, stopped_judge). Without this option, they "
        "aren't run again until they change. Other results are always kept",
    )


def _add_gradebook(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--format",
        metavar="LIST",
        default="",
        help="more export formats of the gradebook, separated by commas: html (a page for each student, and one "
        "for the class), gradescope, canvas, moodle, nbgrader",
    )
    parser.add_argument(
        "--column", metavar="NAME", help='the name of the exercise in Canvas or Moodle: "Exercise 09 (12345)"'
    )
    parser.add_argument(
        "--no-bom",
        action="store_true",
        help="write CSV files without the byte order mark that Excel needs, for a system that rejects it",
    )


def _add_appeals(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--override",
        metavar="CSV",
        type=Path,
        help="lines of `student,exercise,criterion,points,reason,who`: marks to change after an appeal. They are "
        "stored in DIR, and later runs apply them, too. Without PATH, nothing is judged",
    )


def _add_criteria(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--regrade",
        action="store_true",
        help="run no answer: rejudge the stored recordings by the current criteria",
    )
    parser.add_argument(
        "--criteria",
        metavar="FOLDER",
        type=Path,
        help="a folder outside the course with your own hidden criteria (NN_slug.py)",
    )


def _add_hand_ins(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--aliases",
        metavar="CSV",
        type=Path,
        help="lines of `file or folder,student`: which student a hand-in belongs to",
    )
    parser.add_argument(
        "--assignment",
        metavar="NAME",
        help="the exercise's name in nbgrader: only submitted/STUDENT/NAME/ is read",
    )


def _add_lateness(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--deadline",
        metavar="DATE",
        help="the deadline, such as 2026-05-31T23:59, with +02:00 for another zone; a date alone means the end of "
        "that day",
    )
    parser.add_argument(
        "--timezone",
        metavar="NAME",
        help="the time zone of deadlines that don't name one (default: this machine's)",
    )
    parser.add_argument(
        "--extensions",
        metavar="CSV",
        type=Path,
        help="lines of `student,deadline`: deadlines for individual students",
    )
    parser.add_argument(
        "--late-per-day",
        metavar="SHARE",
        type=float,
        default=0.0,
        help="share of the points to subtract per day after the deadline, such as 0.1; a started day counts as a "
        "whole one",
    )


def _add_repetition(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--repeat",
        metavar="N",
        type=int,
        help="judge each answer N times, and list those whose verdict changes; the gradebook stays unchanged",
    )
    parser.add_argument(
        "--similar",
        action="store_true",
        help="judge nothing: list pairs of answers that differ only in names and layout. This is a hint, never a "
        "verdict",
    )


def gradebook_options(options: argparse.Namespace) -> "GradebookOptions":
    """Return the options for the gradebook and its exports. Raises BadOption if one is invalid."""
    from workbook.grading.exports import FORMATS
    from workbook.grading.gradebook import GradebookOptions
    from workbook.grading.roster import BadOption

    formats = tuple(filter(None, (name.strip().lower() for name in options.format.split(","))))
    for name in formats:
        if name not in FORMATS:
            raise BadOption(f"--format {name}: the formats are {', '.join(FORMATS)}")
    lateness = _lateness(options)
    if options.assignment is not None and Path(options.assignment).name != options.assignment:
        raise BadOption(f"--assignment {options.assignment}: give the name of a folder, without a /")
    return GradebookOptions(formats, lateness, options.column, options.assignment, bom=not options.no_bom)


def _lateness(options: argparse.Namespace) -> "Lateness | None":
    """Return the late penalty, or None if there is no deadline. Raises BadOption if an option is invalid."""
    from workbook.grading.deadlines import FORM, parse_deadline, read_extensions, zone_named
    from workbook.grading.lateness import Lateness
    from workbook.grading.roster import BadOption

    if options.deadline is None:
        for given, name in (
            (options.late_per_day, "--late-per-day"),
            (options.extensions, "--extensions"),
            (options.timezone, "--timezone"),
        ):
            if given:
                raise BadOption(f"{name} needs --deadline")
        return None
    zone = zone_named(options.timezone)
    deadline = parse_deadline(options.deadline, zone)
    if deadline is None:
        raise BadOption(f"--deadline {options.deadline}: write it as {FORM}")
    if not 0.0 < options.late_per_day <= 1.0:
        raise BadOption("--deadline needs --late-per-day with a share above 0 and at most 1, such as 0.1")
    extensions = {} if options.extensions is None else read_extensions(options.extensions, zone)
    return Lateness(deadline, options.late_per_day, extensions)


def roster(options: argparse.Namespace) -> "Roster":
    """Return the roster, which maps hand-ins to students. Raises BadOption if the file with aliases is invalid."""
    from workbook.grading.roster import Roster, read_aliases

    return Roster(read_aliases(options.aliases) if options.aliases else {}, options.assignment)
