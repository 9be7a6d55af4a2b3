"""Check whether the mutant reports are still up to date with their programs and criteria, without running anything."""

from collections.abc import Iterator

from workbook.authoring.mutants.programs import all_mutants, inputs_of, right_programs
from workbook.authoring.mutants.report import Report, read_report
from workbook.authoring.tree import AuthoringError, Tree, stems_in
from workbook.authoring.violations import Violation
from workbook.exercise.definition import BrokenCriteria, Exercise, load_exercise
from workbook.exercise.source import SourceError


def outdated_reports(tree: Tree) -> Iterator[Violation]:
    """Yield a note for each report whose inputs have changed since it was made. These notes aren't failures."""
    for stem, report, inputs in _reports(tree):
        changed = sorted(name for name in inputs if report.inputs.get(name) != inputs[name])
        if changed:
            words = f"made before the last change of {', '.join(changed)}: `make mutants ARGS='--only {stem[:2]}'`"
            yield Violation(tree.name(tree.mutants / f"{stem}.toml"), words)


def lost_mutants(tree: Tree) -> Iterator[Violation]:
    """Yield a violation for each unreadable report, and for each mutant that the operators no longer generate."""
    for stem in stems_in(tree.mutants, ".toml"):
        if stem not in tree.exercise_stems():  # reported as misplaced
            continue
        try:
            yield from _lost(tree, stem)
        except AuthoringError as error:
            yield Violation(tree.name(tree.mutants / f"{stem}.toml"), str(error))
        except (BrokenCriteria, SourceError):  # reported with the exercise
            continue


def _lost(tree: Tree, stem: str) -> Iterator[Violation]:
    report = read_report(tree.mutants / f"{stem}.toml")
    exercise = load_exercise(stem, tree.root)
    if not report.survivors or not _may_have_lost(tree, exercise, report):
        return
    there = {one.id for one in all_mutants(exercise, right_programs(tree, exercise, report.right))}
    for one in report.survivors:
        if one.id not in there:
            words = (
                f"names the mutant {one.id} ({one.before} → {one.after}), which cannot be made any more: "
                f"`make mutants ARGS='--only {stem[:2]}'`, or delete it there"
            )
            yield Violation(tree.name(tree.mutants / f"{stem}.toml"), words)


def _may_have_lost(tree: Tree, exercise: Exercise, report: Report) -> bool:
    """Return whether the programs or operators have changed since the report. Criteria don't affect the mutants."""
    inputs = inputs_of(exercise, right_programs(tree, exercise, report.right))
    return any(report.inputs.get(name) != inputs[name] for name in inputs if name != "criteria")


def _reports(tree: Tree) -> Iterator[tuple[str, Report, dict[str, str]]]:
    """Yield the stem, the report, and the current input hashes of each readable report."""
    for stem in stems_in(tree.mutants, ".toml"):
        if stem in tree.exercise_stems():
            try:
                report = read_report(tree.mutants / f"{stem}.toml")
                exercise = load_exercise(stem, tree.root)
                inputs = inputs_of(exercise, right_programs(tree, exercise, report.right))
            except (
                AuthoringError,
                BrokenCriteria,
                SourceError,
            ):  # reported with the exercise, or by `lost_mutants`
                continue
            yield stem, report, inputs
