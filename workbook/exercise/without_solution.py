"""Remove the solution from an exercise's source, for the students' edition and for the farm's machines."""

from workbook.exercise.percent_script import SourceCell, cells_of
from workbook.exercise.source import ExerciseSource
from workbook.exercise.source_header import LEFT_OUT, SOLUTION, split_header


def without_solution(source: ExerciseSource, *, hints: bool) -> str:
    """Return an exercise's source with the starter instead of the solution, and with a header that says so.

    `hints`: whether to keep the hints. The alternatives to the solution are always removed.
    """
    lines = list(enumerate(source.path.read_text(encoding="utf-8").splitlines(), start=1))
    _, remaining = split_header(source.path, lines)
    header = [text for _, text in lines[: len(lines) - len(remaining)]]
    header.insert(-1, f"# {SOLUTION}: {LEFT_OUT}")
    cells = [_kept(cell, source, hints=hints) for cell in cells_of(source.path, remaining)]
    return "\n".join([*header, *cells]) + "\n"


def _kept(cell: SourceCell, source: ExerciseSource, *, hints: bool) -> str:
    body = "\n".join(text for _, text in cell.body).rstrip()
    if cell.kind == "answer":
        body = source.starter_code.rstrip()
    elif cell.kind == "alternatives" or (cell.kind == "hint" and not hints):
        body = "# None."
    return f"# %% [{cell.kind}]\n{body}"
