"""Find stale, misplaced, missing, or incorrect files without running anything."""

from collections.abc import Iterator

from workbook.authoring import document
from workbook.authoring.exercise import read_exercise, starter_document
from workbook.authoring.exercise_rules import (
    answer_violations,
    from_error,
    points_violations,
    story_violations,
)
from workbook.authoring.figure import check_figure
from workbook.authoring.lesson import read_lesson
from workbook.authoring.lesson_links import link_violations
from workbook.authoring.letters import letter_violations
from workbook.authoring.output_rules import compared_enough, outputs_in_order
from workbook.authoring.pages import check_pages
from workbook.authoring.placement import misplaced
from workbook.authoring.predictions import foreign_sealed, prediction_violations, sealed_violations
from workbook.authoring.requirements import stale_exceptions, table_violations
from workbook.authoring.size import size_violations
from workbook.authoring.staleness import dead_links, stale
from workbook.authoring.template import shape_violations
from workbook.authoring.tree import AuthoringError, Tree
from workbook.authoring.violations import Violation
from workbook.exercise.source import DEEPER


def check(tree: Tree) -> list[Violation]:
    """Return all violations in a course's lessons and exercises."""
    found = list(misplaced(tree))
    for stem in tree.lesson_stems():
        found += check_lesson(tree, stem)
    for stem in tree.exercise_stems():
        found += check_exercise(tree, stem)
    found += stale_exceptions(tree)
    found += check_pages(tree)
    found += check_figure(tree)
    found += foreign_sealed(tree)
    found += letter_violations(tree)
    return found


def check_lesson(tree: Tree, stem: str) -> Iterator[Violation]:
    """Check one lesson's text, its built notebook, and the outputs in it."""
    path = tree.sources / f"{stem}.py"
    name = tree.name(path)
    try:
        wanted = read_lesson(tree, stem)
    except AuthoringError as error:
        yield Violation(name, str(error).removeprefix(name).lstrip(":, "))
        return
    is_deeper = stem.endswith(DEEPER)
    has_exercise = not is_deeper and any(other[:2] == stem[:2] for other in tree.exercise_stems())
    text = path.read_text(encoding="utf-8")
    for line, words in (
        *shape_violations(wanted.cells, int(stem[:2]), has_exercise=has_exercise, is_deeper=is_deeper),
        *size_violations(tree, stem, text, wanted),
        *link_violations(tree, stem, text),
        *prediction_violations(wanted),
        *compared_enough(wanted),
        *dead_links(tree, tree.notebooks, wanted),
    ):
        yield Violation(name, words, line)
    yield from _built_lesson(tree, stem, wanted)


def _built_lesson(tree: Tree, stem: str, wanted: document.Document) -> Iterator[Violation]:
    target = tree.notebooks / f"{stem}.ipynb"
    yield from sealed_violations(tree, stem, wanted)
    yield from stale(tree, target, wanted)
    if target.is_file():
        try:
            built = document.read(target)
        except ValueError:  # `stale` has already reported it
            return
        yield from (Violation(tree.name(target), words) for words in outputs_in_order(built))


def check_exercise(tree: Tree, stem: str) -> Iterator[Violation]:
    """Check one exercise: its source, criteria, notebook, requirements, and its right and wrong answers."""
    path = tree.solutions / f"{stem}.py"
    exercise = None
    try:
        exercise = read_exercise(tree, stem)
    except AuthoringError as error:
        yield from_error(tree, error, path)
    else:
        yield from story_violations(tree, exercise)
        yield from points_violations(tree, exercise)
        wanted = starter_document(tree, exercise)
        for _, words in dead_links(tree, tree.exercises, wanted):
            yield Violation(tree.name(path), words)
        yield from stale(tree, tree.exercises / f"{stem}.ipynb", wanted)
    if not any(other[:2] == stem[:2] for other in tree.lesson_stems()):
        yield Violation(
            tree.name(path),
            f"no lesson {stem[:2]} leads to this exercise: `workbook new lesson {stem}` begins one",
        )
    yield from answer_violations(tree, stem, exercise)
    yield from table_violations(tree, stem, exercise)
