"""Build notebooks from their texts, which are in `notebooks/sources/` (lessons) and `solutions/` (exercises)."""

import time
from collections.abc import Callable, Iterable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from workbook.authoring import document
from workbook.authoring.exercise import read_exercise, solved_notebook, starter_document
from workbook.authoring.figure import FILE, write_figure
from workbook.authoring.lesson import read_lesson
from workbook.authoring.lesson_links import write_links
from workbook.authoring.lesson_lists import note_run_times
from workbook.authoring.pages import write_pages
from workbook.authoring.predictions import write_sealed
from workbook.authoring.running import run
from workbook.authoring.size import write_sizes
from workbook.authoring.tree import AuthoringError, Tree
from workbook.exercise.museum import BrokenMuseum

Say = Callable[[str], None]


def build(
    tree: Tree, names: Iterable[str] = (), *, again: bool = False, jobs: int = 1, say: Say = print
) -> int:
    """Build the named lessons and exercises, or all of them if no names are given. Return the number of failures.

    A lesson runs again only if its code has changed or `again` is true. Up to `jobs` lessons run in parallel. `say` is
    called with one line per file, and with the reason for each failure.
    """
    lessons, exercises = select(tree, names)
    failed = 0

    def attempt(step: Callable[[Tree, str], str]) -> Callable[[str], tuple[bool, str]]:
        def tried(stem: str) -> tuple[bool, str]:
            try:
                return True, step(tree, stem)
            except AuthoringError as error:
                return False, f"FAILED  {error}"

        return tried

    def lesson(tree: Tree, stem: str) -> str:
        return build_lesson(tree, stem, again=again)

    for stem in write_links(tree):
        say(f"links      {tree.name(tree.sources / f'{stem}.py')}")
    for stem in write_sizes(tree):
        say(f"minutes    {tree.name(tree.sources / f'{stem}.py')}")
    with ThreadPoolExecutor(max_workers=max(1, jobs)) as pool:
        for good, words in pool.map(attempt(lesson), lessons):
            failed += not good
            say(words)
    for good, words in map(attempt(build_exercise), exercises):
        failed += not good
        say(words)
    if write_figure(tree):
        say(f"built      {FILE}")
    try:
        for path in write_pages(tree):
            say(f"built      {tree.name(path)}")
    except (AuthoringError, BrokenMuseum) as error:
        failed += 1
        say(f"FAILED  {error}")
    return failed


def select(tree: Tree, names: Iterable[str]) -> tuple[list[str], list[str]]:
    """Return the stems of the lessons and exercises that match the names, or of all of them if no names are given.

    A name is a stem, a slug, a number, or a file. Raises AuthoringError if a name doesn't match anything.
    """
    lessons, exercises = list(tree.lesson_stems()), list(tree.exercise_stems())
    wanted = [Path(name).stem for name in names]
    if not wanted:
        return lessons, exercises
    for name in wanted:
        if not any(_fits(stem, name) for stem in lessons + exercises):
            known = ", ".join(sorted({*lessons, *exercises})) or "none yet"
            raise AuthoringError(f"no lesson or exercise is called {name!r}. There are: {known}")

    def chosen(stems: list[str]) -> list[str]:
        return [stem for stem in stems if any(_fits(stem, name) for name in wanted)]

    return chosen(lessons), chosen(exercises)


def _fits(stem: str, name: str) -> bool:
    return name in (stem, stem[3:], stem[:2])


def build_lesson(tree: Tree, stem: str, *, again: bool = False) -> str:
    """Build one lesson. Run it only if its code or a lesson node that it uses has changed, or if `again` is true.

    Return a line that reports the result to the author.
    """
    target = tree.notebooks / f"{stem}.ipynb"
    read = read_lesson(tree, stem)
    wanted = document.as_notebook(read)
    write_sealed(tree, stem, read.predictions)
    if not again and is_current(target, wanted):
        return f"unchanged  {tree.name(target)}"
    if not again and carry_outputs(target, wanted):
        document.write(target, document.to_text(wanted))
        return f"new words  {tree.name(target)}"
    began = time.monotonic()
    run(tree, stem, wanted)
    note_run_times(tree, {stem: time.monotonic() - began})
    document.write(target, document.to_text(wanted))
    return f"built      {tree.name(target)}"


def is_current(target: Path, wanted: document.Notebook) -> bool:
    """Return whether the notebook at `target` matches the `wanted` one and all of its code cells have run."""
    if not target.is_file():
        return False
    try:
        built = document.read(target)
    except ValueError:
        return False
    if not all(cell.execution_count for cell in built.cells if cell.cell_type == "code"):
        return False
    return bool(document.without_outputs(built) == document.without_outputs(wanted))


def carry_outputs(target: Path, wanted: document.Notebook) -> bool:
    """Copy the outputs of the notebook at `target` to `wanted` if only the text between the code cells has changed.

    Return whether the outputs were copied. If they weren't, the lesson has to run.
    """
    try:
        built = document.read(target)
    except ValueError:
        return False

    def code(notebook: document.Notebook) -> list[Any]:
        return [cell for cell in notebook.cells if cell.cell_type == "code"]

    def shown_cells(cells: list[Any]) -> list[tuple[str, str, Any]]:
        return [(cell.id, cell.source, cell.metadata) for cell in cells]

    shown = code(built)
    if built.metadata != wanted.metadata or shown_cells(shown) != shown_cells(code(wanted)):
        return False
    if not all(cell.execution_count for cell in shown):
        return False
    for cell, before in zip(code(wanted), shown, strict=True):
        cell.outputs, cell.execution_count = before.outputs, before.execution_count
    return True


def build_exercise(tree: Tree, stem: str) -> str:
    """Build an exercise's notebook and its solved version without running either.

    Return a line that reports the result to the author.
    """
    exercise = read_exercise(tree, stem)
    target = tree.exercises / f"{stem}.ipynb"
    text = document.to_text(document.as_notebook(starter_document(tree, exercise)))
    written = document.write(target, text)
    document.write(tree.solved / f"{stem}.ipynb", document.to_text(solved_notebook(tree, exercise)))
    return f"{'built     ' if written else 'unchanged '} {tree.name(target)}"
