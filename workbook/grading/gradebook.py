"""Write the gradebook from results.jsonl: grades.csv, pages, and exports for other systems."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbook.exercise.definition import Exercise
from workbook.grading.appeals import kept, with_changes
from workbook.grading.class_page import class_page
from workbook.grading.exports import canvas, gradescope, moodle, nbgrader
from workbook.grading.files import write_whole
from workbook.grading.grades_csv import grades_csv
from workbook.grading.handed_in import with_a_hand_in
from workbook.grading.lateness import Lateness, with_lateness
from workbook.grading.pages import CLASS, PAGES, page_name, student_page
from workbook.grading.results import Result, StudentAndExercise

GRADES = "grades.csv"


@dataclass(frozen=True)
class GradebookOptions:
    """The exports to write in addition to grades.csv, and their options.

    `column`: the exercise's name in Canvas and Moodle. `assignment`: its name in nbgrader. `bom`: whether tables begin
    with a byte order mark. nbgrader.csv never does.
    """

    formats: tuple[str, ...] = ()
    lateness: Lateness | None = None
    column: str | None = None
    assignment: str | None = None
    bom: bool = True


def write_gradebook(
    out: Path,
    exercise: Exercise,
    results: Mapping[StudentAndExercise, Result],
    options: GradebookOptions | None = None,
) -> list[Path]:
    """Write grades.csv and the requested exports under `out`. Return the paths of the files and folders written.

    All of them include the changes that a person made to marks (see `appeals`). Raises BadOption if these changes can't
    be read.
    """
    options = options or GradebookOptions()
    changed = with_changes(with_a_hand_in(out, results.values()), kept(out))
    everything = with_lateness(changed, options.lateness)
    mine = [result for result in everything if result.exercise == exercise.stem]
    written = [write_whole(out / GRADES, grades_csv(everything), bom=options.bom)]
    title = options.column or exercise.source.title
    if "canvas" in options.formats:
        written.append(
            write_whole(out / "canvas.csv", canvas(mine, title, exercise.max_points), bom=options.bom)
        )
    if "moodle" in options.formats:
        written.append(write_whole(out / "moodle.csv", moodle(mine, title), bom=options.bom))
    if "nbgrader" in options.formats:
        written.append(write_whole(out / "nbgrader.csv", nbgrader(mine, options.assignment)))
    if "gradescope" in options.formats:
        written.append(_write_gradescope(out / "gradescope", mine))
    if "html" in options.formats:
        written.append(_write_pages(out, exercise, mine))
    return written


def _write_gradescope(folder: Path, results: Iterable[Result]) -> Path:
    for result in results:
        name = page_name(result.student, result.exercise).removesuffix(".html")
        write_whole(folder / f"{name}.json", gradescope(result))
    return folder


def _write_pages(out: Path, exercise: Exercise, results: Sequence[Result]) -> Path:
    for result in results:
        write_whole(
            out / PAGES / page_name(result.student, result.exercise), student_page(result, exercise, out)
        )
    return write_whole(out / PAGES / CLASS, class_page(results, exercise))
