"""Build the table for `%progress`: lessons read, predictions made, and exercises solved, by lesson."""

import textwrap
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from workbook.lesson.course_map import CourseMap, LessonState, course_map
from workbook.lesson.progress import LessonProgress
from workbook.templating import render

_HEAD = ("lesson", "read", "predicted", "exercise", "points")
_GAP = "  "
_SHORTEST_TITLE = 16


def _cut(text: str, width: int) -> str:
    return text if len(text) <= width else f"{text[: width - 1]}…"


@dataclass(frozen=True)
class LessonRow:
    """A table row: one lesson, as text."""

    state: LessonState

    @property
    def title(self) -> str:
        """The lesson's title."""
        return self.state.title

    @property
    def read(self) -> str:
        """The percentage of the lesson's cells that the student has read, as text."""
        done, of = self.state.cells
        if not done:
            return "–"
        return "✓ all" if done >= of else f"{'✓ ' if self.state.is_read else ''}{100 * done // of} %"

    @property
    def predicted(self) -> str:
        """The number of predictions made, as text, or an empty string if the lesson doesn't ask for any."""
        done, of = self.state.predictions
        return f"{done} of {of}" if of else ""

    @property
    def exercise(self) -> str:
        """The exercise's status, as text, or an empty string if the lesson has no exercise."""
        exercise = self.state.exercise
        if exercise is None:
            return ""
        if exercise.solved:
            return "✓ solved"
        return f"{exercise.tries} {'try' if exercise.tries == 1 else 'tries'}" if exercise.tries else "–"

    @property
    def score(self) -> str:
        """The most points earned so far, as text, or an empty string before the first try."""
        exercise = self.state.exercise
        return f"{exercise.points[0]:g} of {exercise.points[1]:g}" if exercise and exercise.tries else ""

    def columns(self) -> tuple[str, ...]:
        """Return the row as text, one entry per column."""
        return (self.title, self.read, self.predicted, self.exercise, self.score)


class ProgressTable:
    """A student's progress in the whole course, shown in a notebook or as text."""

    def __init__(self, course: CourseMap) -> None:
        self.course = course
        self.rows = tuple(LessonRow(one) for one in course.lessons)

    @property
    def warnings(self) -> list[str]:
        """A line for each exercise whose file to hand in isn't the best version."""
        return [
            f"{one.stem}: the file to hand in is not your best version. To restore your best one, run "
            f"%restore {one.stem[:2]} in its notebook, or workbook restore {one.stem[:2]} in a terminal."
            for one in self.course.not_best
        ]

    @property
    def summary(self) -> str:
        """A summary of the totals."""
        sums = self.course.sums
        (read, lessons), (solved, exercises) = sums["lessons read"], sums["exercises solved"]
        points, most = sums["points"]
        return (
            f"{read} of {lessons} lessons read, {solved} of {exercises} exercises solved, {points:g} of {most:g} "
            "points. A lesson counts as read when you have run its cells one by one."
        )

    @property
    def next_step(self) -> str:
        """A sentence that suggests the next step."""
        return self.course.next_step

    def text(self, columns: int | None = None) -> str:
        """Return the table for a terminal. Titles are cut if the table is wider than `columns` characters."""
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
    """Return this student's progress table.

    `course`, `done`, and `answers` default to the installed course and the saved progress.
    """
    return ProgressTable(course_map(course, done, answers))
