"""The table of `%progress`: lesson by lesson, what was read, predicted and solved."""

import json
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbook.exercise.course import course_folder
from workbook.exercise.definition import load_exercise
from workbook.exercise.source import DEEPER, stems
from workbook.lesson.best_answers import hands_in_another
from workbook.lesson.progress import LessonProgress, all_progress
from workbook.templating import render

_HEAD = ("lesson", "read", "predicted", "exercise", "points")
_GAP = "  "
_SHORTEST_TITLE = 16


def _cut(text: str, width: int) -> str:
    return text if len(text) <= width else f"{text[: width - 1]}…"


@dataclass(frozen=True)
class LessonRow:
    """One lesson: code cells and predictions (done, of how many), and its exercise, if it has one."""

    title: str
    cells: tuple[int, int]
    predictions: tuple[int, int]
    points: tuple[float, float] | None
    tries: int
    solved: bool
    optional: bool = False
    """A notebook that goes deeper than its lesson."""

    @property
    def read(self) -> str:
        """How much of the lesson was run, in words."""
        done, of = self.cells
        if not done:
            return "–"
        return "✓ all" if done >= of else f"{round(100 * done / of)} %"

    @property
    def predicted(self) -> str:
        """How many predictions were made, in words; empty where the lesson asks for none."""
        done, of = self.predictions
        return f"{done} of {of}" if of else ""

    @property
    def exercise(self) -> str:
        """The state of the exercise, in words; empty where there is none."""
        if self.points is None:
            return ""
        if self.solved:
            return "✓ solved"
        return f"{self.tries} {'try' if self.tries == 1 else 'tries'}" if self.tries else "–"

    @property
    def score(self) -> str:
        """The most points so far, in words; empty before the first try."""
        if self.points is None or not self.tries:
            return ""
        return f"{self.points[0]:g} of {self.points[1]:g}"

    def columns(self) -> tuple[str, ...]:
        """The row as text, one entry per column."""
        return (self.title, self.read, self.predicted, self.exercise, self.score)


class ProgressTable:
    """What a student has done in the whole course; shows itself in a notebook and as text.

    `not_best`: exercises whose file to hand in is not the best version.
    """

    def __init__(self, rows: Sequence[LessonRow], not_best: Sequence[str] = ()) -> None:
        self.rows = tuple(rows)
        self.not_best = tuple(not_best)

    @property
    def warnings(self) -> list[str]:
        """One line for each exercise whose file to hand in is not the best version."""
        return [
            f"{stem}: the file to hand in is not your best version. %restore {stem[:2]} in its notebook, or "
            f"workbook restore {stem[:2]} in a terminal, puts that back."
            for stem in self.not_best
        ]

    @property
    def summary(self) -> str:
        """One sentence with the sums."""
        lessons = [row for row in self.rows if not row.optional]
        read = sum(row.cells[0] >= row.cells[1] for row in lessons if row.cells[1])
        exercises = [row for row in self.rows if row.points is not None]
        solved = sum(row.solved for row in exercises)
        points = sum(row.points[0] for row in exercises if row.points is not None)
        most = sum(row.points[1] for row in exercises if row.points is not None)
        return (
            f"{read} of {len(lessons)} lessons read to the end, {solved} of {len(exercises)} exercises solved, "
            f"{points:g} of {most:g} points."
        )

    @property
    def next_step(self) -> str:
        """The first lesson that is not done yet. Nobody has to read an optional notebook."""
        for row in self.rows:
            if row.optional:
                continue
            if row.cells[0] < row.cells[1]:
                return f"Go on with: {row.title}"
            if row.points is not None and not row.solved:
                return f"Go on with the exercise of: {row.title}"
        return "You have done all there is. Well done!"

    def text(self, columns: int | None = None) -> str:
        """The table for a terminal. Titles are cut where `columns` would not hold them."""
        lines = [_HEAD, *(row.columns() for row in self.rows)]
        widths = [max(len(line[place]) for line in lines) for place in range(len(_HEAD))]
        if columns is not None:
            over = sum(widths) + len(_GAP) * (len(widths) - 1) - columns
            widths[0] = max(_SHORTEST_TITLE, widths[0] - max(0, over))
        table = [
            _GAP.join(
                _cut(text, width).ljust(width) for text, width in zip(line, widths, strict=True)
            ).rstrip()
            for line in lines
        ]
        table.insert(1, _GAP.join("─" * width for width in widths))
        said = [*self.warnings, self.summary]
        if columns is not None:
            said = [line for text in said for line in textwrap.wrap(text, columns)]
        return "\n".join([*table, "", *said, self.next_step])

    def __str__(self) -> str:
        return self.text()

    __repr__ = __str__

    def _repr_html_(self) -> str:
        return render(
            "magics/overview",
            head=_HEAD,
            rows=self.rows,
            warnings=self.warnings,
            summary=self.summary,
            next_step=self.next_step,
        )


def progress_table(
    course: Path | None = None,
    done: Mapping[str, LessonProgress] | None = None,
    answers: Path | None = None,
) -> ProgressTable:
    """The state of this student. `course`, `done` and `answers` default to what is installed and what is kept."""
    folder = course_folder() if course is None else course
    kept = all_progress() if done is None else done
    exercises = set(stems(folder / "solutions"))
    rows = []
    for path in sorted((folder / "notebooks").glob("[0-9][0-9]_*.ipynb")):
        progress = kept.get(path.stem, LessonProgress())
        title, cells, questions = _lesson(path)
        points = None
        if path.stem in exercises:
            exercise = load_exercise(path.stem, folder)
            most = sum(one.points for one in exercise.criteria if not one.hidden)
            points = (progress.best, most)
        rows.append(
            LessonRow(
                title=title,
                cells=(len(cells & set(progress.cells)), len(cells)),
                predictions=(min(len(progress.predictions), questions), questions),
                points=points,
                tries=progress.tries,
                solved=progress.solved,
                optional=path.stem.endswith(DEEPER),
            )
        )
    return ProgressTable(rows, [stem for stem in sorted(exercises) if hands_in_another(stem, answers)])


def _lesson(path: Path) -> tuple[str, set[str], int]:
    """Title, ids of the code cells, and how many predictions the lesson asks for."""
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    sources = {cell["id"]: "".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"}
    first = "".join(cells[0]["source"]).splitlines()[0]
    questions = sum(
        source.lstrip().startswith("predict(") or "\npredict(" in source for source in sources.values()
    )
    return first.lstrip("# ").strip(), set(sources), questions
