"""Compute the course map: lessons read, predictions made, exercises solved, and where to continue.

`%progress`, `workbook progress`, and the home page show the results.
"""

import json
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

from workbook.exercise.course import course_folder
from workbook.exercise.definition import load_exercise
from workbook.exercise.source import DEEPER, stems
from workbook.lesson.best_answers import hands_in_another
from workbook.lesson.progress import LessonProgress, all_progress

READ_SHARE = 0.9
"""A lesson counts as read when this fraction of its code cells has been run one by one."""
_FENCED = re.compile(r"^```.*?^```", re.MULTILINE | re.DOTALL)
_HEADING = re.compile(r"^#{1,3} +(.+)$", re.MULTILINE)
_ABLE_TO = re.compile(r"^- \*\*You will be able to:\*\*\s*(?:- )?(.+(?:\n {2,}(?!- ).+)*)", re.MULTILINE)
_ASKS = re.compile(r"^predict\(\s*[\"']([^\"']+)", re.MULTILINE)


@dataclass(frozen=True)
class CellToGoOnAt:
    """A cell where the student can continue: its notebook (relative to the student's folder), ID, and heading."""

    notebook: str
    cell: str
    heading: str


@dataclass(frozen=True)
class CodeCell:
    """A lesson's code cell. `asks`: the name of the prediction that it asks for, or an empty string."""

    id: str
    heading: str
    asks: str


@dataclass(frozen=True)
class LessonText:
    """A lesson's contents. `promise`: the first skill that the lesson's introduction lists."""

    stem: str
    title: str
    minutes: str
    promise: str
    cells: tuple[CodeCell, ...]


@dataclass(frozen=True)
class ExerciseState:
    """The state of an exercise.

    `points`: the points earned and the maximum. `tries`: the number of judged tries. `hands_in_another`: whether the
    file to hand in isn't the best version.
    """

    title: str
    points: tuple[float, float]
    tries: int
    solved: bool
    hands_in_another: bool


@dataclass(frozen=True)
class LessonState:
    """The state of one lesson.

    `cells` and `predictions`: the number done and the total number. `exercise`: its state, or None if the lesson has no
    exercise. `place`: the cell at which to continue reading, or None if every cell was read. `missing`: the first
    unread cell under each heading. `touched`: the time at which the student last worked on the lesson, as a Unix
    timestamp in seconds, or 0.
    """

    stem: str
    title: str
    minutes: str
    promise: str
    cells: tuple[int, int]
    predictions: tuple[int, int]
    exercise: ExerciseState | None
    place: CellToGoOnAt | None
    missing: tuple[CellToGoOnAt, ...]
    touched: float

    @property
    def is_optional(self) -> bool:
        """Whether this lesson is optional, as all deeper lessons are."""
        return self.stem.endswith(DEEPER)

    @property
    def is_read(self) -> bool:
        """Whether enough of the lesson's code cells were read (see `READ_SHARE`)."""
        return self.cells_to_go == 0

    @property
    def cells_to_go(self) -> int:
        """The number of cells still to be read until the lesson counts as read."""
        done, of = self.cells
        return max(0, math.ceil(READ_SHARE * of) - done)

    @property
    def is_done(self) -> bool:
        """Whether the lesson is read and its exercise, if any, is solved."""
        return self.is_read and (self.exercise is None or self.exercise.solved)

    @property
    def lesson_path(self) -> str:
        """The path of the lesson's notebook, relative to the student's folder."""
        return f"notebooks/{self.stem}.ipynb"

    @property
    def exercise_path(self) -> str:
        """The path of the exercise's notebook, relative to the student's folder."""
        return f"exercises/{self.stem}.ipynb"


@dataclass(frozen=True)
class CourseMap:
    """A student's progress in all lessons."""

    lessons: tuple[LessonState, ...]

    @property
    def has_begun(self) -> bool:
        """Whether the student has done anything yet."""
        return any(one.touched or one.cells[0] or one.predictions[0] for one in self.lessons)

    @property
    def next_lesson(self) -> LessonState | None:
        """The lesson to work on next, or None if all lessons are done.

        It's the unfinished lesson that the student worked on last, or else the first unfinished one. Optional lessons
        are never next.
        """
        unfinished = [one for one in self.lessons if not one.is_done and not one.is_optional]
        return max(unfinished, key=lambda one: one.touched, default=None)

    @property
    def next_step(self) -> str:
        """A sentence that suggests the next step."""
        lesson = self.next_lesson
        if lesson is None:
            return "You've completed the whole course. Well done!"
        if lesson.is_read:
            return f"Continue with the exercise of: {lesson.title}"
        begun = lesson.place is not None and lesson.cells[0] > 0
        return f"Continue with: {lesson.title}" + (
            f", at “{lesson.place.heading}”" if begun and lesson.place else ""
        )

    @property
    def exercises(self) -> list[ExerciseState]:
        """All exercises of the course."""
        return [one.exercise for one in self.lessons if one.exercise is not None]

    @property
    def sums(self) -> dict[str, tuple[float, float]]:
        """The number done and the total, for lessons read, predictions made, exercises solved, and points.

        Optional lessons and their predictions don't count.
        """
        of = self.exercises
        lessons = [one for one in self.lessons if not one.is_optional]
        return {
            "lessons read": (sum(one.is_read for one in lessons), len(lessons)),
            "predictions made": (
                sum(one.predictions[0] for one in lessons),
                sum(one.predictions[1] for one in lessons),
            ),
            "exercises solved": (sum(one.solved for one in of), len(of)),
            "points": (sum(one.points[0] for one in of), sum(one.points[1] for one in of)),
        }

    @property
    def share(self) -> int:
        """The percentage of the course that is done. Each lesson read and each exercise solved has equal weight."""
        parts = [self.sums[name] for name in ("lessons read", "exercises solved")]
        return int(100 * sum(done for done, _ in parts) / max(1, sum(of for _, of in parts)))

    @property
    def not_best(self) -> list[LessonState]:
        """The lessons whose file to hand in isn't the answer's best version."""
        return [one for one in self.lessons if one.exercise is not None and one.exercise.hands_in_another]


def course_map(
    course: Path | None = None,
    done: Mapping[str, LessonProgress] | None = None,
    answers: Path | None = None,
) -> CourseMap:
    """Return this student's course map.

    `course`, `done`, and `answers` default to the installed course and the saved progress.

    Raise NoCourse if there is no course, BrokenCriteria if an exercise can't be loaded, or OSError if a lesson can't be
    read.
    """
    folder = course_folder() if course is None else course
    kept = all_progress(answers) if done is None else done
    exercises = set(stems(folder / "solutions"))
    found = []
    for path in sorted((folder / "notebooks").glob("[0-9][0-9]_*.ipynb")):
        lesson = _lesson(path, path.stat().st_mtime_ns)
        progress = kept.get(path.stem, LessonProgress())
        exercise = None
        if path.stem in exercises:
            title, most = _exercise(folder, path.stem)
            other = hands_in_another(path.stem, answers)
            exercise = ExerciseState(title, (progress.best, most), progress.tries, progress.solved, other)
        found.append(_state(lesson, progress, exercise))
    return CourseMap(tuple(found))


def _state(lesson: LessonText, progress: LessonProgress, exercise: ExerciseState | None) -> LessonState:
    """Return a lesson's state.

    The cell of a prediction counts as read once the student has made the prediction, even if a Run All ran the cell.
    """
    read = {one.id for one in lesson.cells if one.id in progress.read or one.asks in progress.predictions}
    asked = sum(bool(one.asks) for one in lesson.cells)
    left = [one for one in lesson.cells if one.id not in read]
    later = [one for one in _after_the_last(lesson.cells, read) if one.id not in read]
    missing = {one.id: CellToGoOnAt(f"notebooks/{lesson.stem}.ipynb", one.id, one.heading) for one in left}
    headings = {one.heading: missing[one.id] for one in reversed(left)}
    at = next(iter(later or left), None)
    return LessonState(
        stem=lesson.stem,
        title=lesson.title,
        minutes=lesson.minutes,
        promise=lesson.promise,
        cells=(len(read), len(lesson.cells)),
        predictions=(min(len(progress.predictions), asked), asked),
        exercise=exercise,
        place=missing[at.id] if at else None,
        missing=tuple(reversed(headings.values())),
        touched=progress.touched,
    )


def _after_the_last(cells: tuple[CodeCell, ...], read: set[str]) -> tuple[CodeCell, ...]:
    """Return the cells after the last one read, where a student who skipped an experiment continues."""
    last = max((place for place, one in enumerate(cells) if one.id in read), default=-1)
    return cells[last + 1 :]


@lru_cache(maxsize=256)
def _lesson(path: Path, _mtime: int) -> LessonText:
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    heading, found = "", []
    for cell in cells:
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            heading = [heading, *_HEADING.findall(_FENCED.sub("", source))][-1]
        elif cell["cell_type"] == "code":
            asks = _ASKS.search(source)
            found.append(CodeCell(cell["id"], heading.strip(), asks[1] if asks else ""))
    intro = "".join(cells[0]["source"])
    minutes = re.search(r"\*\*Minutes:\*\* *(\d+)", intro)
    title = intro.splitlines()[0].lstrip("# ").strip()
    able = _ABLE_TO.search(intro)
    promise = " ".join(able[1].split()) if able else ""
    return LessonText(
        path.stem,
        title,
        minutes[1] if minutes else "",
        promise[:1].upper() + promise[1:],
        tuple(found),
    )


@lru_cache(maxsize=256)
def _exercise(course: Path, stem: str) -> tuple[str, float]:
    """Return the exercise's title and the total points of the criteria that students see."""
    exercise = load_exercise(stem, course)
    return exercise.source.title, sum(one.points for one in exercise.criteria if not one.hidden)
