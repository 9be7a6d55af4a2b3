"""`workbook grade --override`: store changes to marks, and report which changes have an effect."""

import argparse
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from workbook.cli.grade_screen import printable, say_broken

if TYPE_CHECKING:
    from workbook.exercise.definition import Exercise
    from workbook.grading.appeals import OverrideLine
    from workbook.grading.gradebook import GradebookOptions
    from workbook.grading.results import Result, StudentAndExercise


def lines_of(options: argparse.Namespace) -> "list[OverrideLine]":
    """Return the lines of the `--override` file, or an empty list if the option isn't given.

    Each line is a change to a student's marks. Raises BadOption if a line is invalid in this file or in the file of
    stored changes.
    """
    from workbook.grading.appeals import kept, read_lines

    kept(options.out)
    return [] if options.override is None else read_lines(options.override)


def take(out: Path, lines: "Sequence[OverrideLine]", results: "Mapping[StudentAndExercise, Result]") -> int:
    """Store the changes if all of them match the results. Otherwise, print the problem and don't store any.

    Return the exit code: 0 if they match, else 2. Raises FolderInUse if another run is using the folder.
    """
    from workbook.grading.appeals import fit, keep
    from workbook.grading.results_file import RESULTS, ResultsFile
    from workbook.grading.roster import BadOption

    try:
        changes = fit(lines, results)
    except BadOption as error:
        print(f"workbook grade: {printable(error)}", file=sys.stderr)
        return 2
    if changes:
        with ResultsFile(out / RESULTS):
            keep(out, changes)
    return 0


def say_changes(out: Path, results: "Mapping[StudentAndExercise, Result]") -> None:
    """Print the marks that a person has changed, and the changes that have no effect."""
    from workbook.grading.appeals import OVERRIDES, deductions, kept, with_changes, without_effect

    changes = kept(out)
    changed = [one for one in with_changes(results.values(), changes) if one.by_hand]
    if changed:
        what = "1 result has" if len(changed) == 1 else f"{len(changed)} results have"
        print(f"{what} marks that a person changed ({out / OVERRIDES}):")
    for one in changed:
        print(f"  {printable(one.student)}: {printable(one.changed_by_hand())}")
    for sentence in (*deductions(results, changes), *without_effect(results, changes)):
        print(f"  {printable(sentence)}.")


def only_override(
    options: argparse.Namespace,
    exercise: "Exercise",
    books: "GradebookOptions",
    lines: "Sequence[OverrideLine]",
) -> int:
    """Change marks and write the gradebook without judging anything. Return the exit code."""
    from workbook.grading.gradebook import write_gradebook
    from workbook.grading.results_file import RESULTS, last_results
    from workbook.grading.roster import BadOption

    if not (options.out / RESULTS).is_file():
        raise BadOption(f"{options.out} has no {RESULTS}: grade first")
    results = last_results(options.out / RESULTS, say_broken)
    if take(options.out, lines, results):
        return 2
    for path in write_gradebook(options.out, exercise, results, books):
        print(f"Written: {path}")
    say_changes(options.out, results)
    return 0
