"""The course as a map: what is read, predicted and solved, lesson by lesson, and where to go on.

`%progress`, `workbook progress` and the home page show these figures.
"""

import json
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
"""Of a lesson's code cells: who ran nine in ten of them one by one has read it."""
_HEADING = re.compile(r"^#{1,3} +(.+)$", re.MULTILINE)
_ASKS = re.compile(r"^predict\(\s*[\"']([^\"']+)", re.MULTILINE)


@dataclass(frozen=True)
class CellToGoOnAt:
    """A cell to go on at: the notebook below the student's folder, the cell's id, the heading that it stands under."""

    notebook: str
    cell: str
    heading: str


@dataclass(frozen=True)
class CodeCell:
    """A code cell of a lesson. `asks`: the name of the prediction that it asks for, or empty."""

    id: str
    heading: str
    asks: str


@dataclass(frozen=True)
class LessonText:
    """What is known of a lesson before anybody has opened it."""

    stem: str
    title: str
    minutes: str
    cells: tuple[CodeCell, ...]


@dataclass(frozen=True)
class ExerciseState:
    """An exercise: its title, points (best, most), judged tries, and whether the file to hand in is the best one."""

    title: str
    points: tuple[float, float]
    tries: int
    solved: bool
    hands_in_another: bool


@dataclass(frozen=True)
class LessonState:
    """One lesson. `cells` and `predictions`: done, of how many. `exercise` is None where there is none.

    `place`: where to go on reading; None when it is read. `touched`: when something was last done in it.
    """

    stem: str
    title: str
    minutes: str
    cells: tuple[int, int]
    predictions: tuple[int, int]
    exercise: ExerciseState | None
    place: CellToGoOnAt | None
    touched: float

    @property
    def is_optional(self) -> bool:
        """Whether this goes deeper than its lesson: nobody has to read it."""
        return self.stem.endswith(DEEPER)

    @property
    def is_read(self) -> bool:
        """Whether nine in ten of its code cells were run one by one."""
        done, of = self.cells
        return done >= READ_SHARE * of

    @property
    def is_done(self) -> bool:
        """Whether it is read, and its exercise solved."""
        return self.is_read and (self.exercise is None or self.exercise.solved)

    @property
    def lesson_path(self) -> str:
        """Its notebook, below the student's folder."""
        return f"notebooks/{self.stem}.ipynb"

    @property
    def exercise_path(self) -> str:
        """The notebook of its exercise, below the student's folder."""
        return f"exercises/{self.stem}.ipynb"


@dataclass(frozen=True)
class CourseMap:
    """The state of one student in all lessons."""

    lessons: tuple[LessonState, ...]

    @property
    def has_begun(self) -> bool:
        """Whether the student has done anything yet."""
        return any(one.touched or one.cells[0] or one.predictions[0] for one in self.lessons)

    @property
    def next_lesson(self) -> LessonState | None:
        """The unfinished lesson that was worked on last, else the first unfinished one; None when all is done.

        Optional ones are never next.
        """
        unfinished = [one for one in self.lessons if not one.is_done and not one.is_optional]
        return max(unfinished, key=lambda one: one.touched, default=None)

    @property
    def next_step(self) -> str:
        """What to do next, in words."""
        lesson = self.next_lesson
        if lesson is None:
            return "You have done all there is. Well done!"
        if lesson.is_read:
            return f"Go on with the exercise of: {lesson.title}"
        begun = lesson.place is not None and lesson.cells[0] > 0
        return f"Go on with: {lesson.title}" + (
            f", at “{lesson.place.heading}”" if begun and lesson.place else ""
        )

    @property
    def exercises(self) -> list[ExerciseState]:
        """All exercises there are."""
        return [one.exercise for one in self.lessons if one.exercise is not None]

    @property
    def sums(self) -> dict[str, tuple[float, float]]:
        """Done, of how many: lessons read, predictions made, exercises solved, points. Optional ones do not count."""
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
    def not_best(self) -> list[LessonState]:
        """Lessons whose file to hand in is not the best version."""
        return [one for one in self.lessons if one.exercise is not None and one.exercise.hands_in_another]


def course_map(
    course: Path | None = None,
    done: Mapping[str, LessonProgress] | None = None,
    answers: Path | None = None,
) -> CourseMap:
    """The state of this student. `course`, `done` and `answers` default to what is installed and what is kept.

    Raises NoCourse, BrokenCriteria, and OSError where a lesson cannot be read.
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
    """What is done of a lesson. A prediction that was made counts as read, however its cell was run."""
    read = {one.id for one in lesson.cells if one.id in progress.read or one.asks in progress.predictions}
    asked = sum(bool(one.asks) for one in lesson.cells)
    left = [one for one in lesson.cells if one.id not in read]
    later = [one for one in _after_the_last(lesson.cells, read) if one.id not in read]
    at = next(iter(later or left), None)
    return LessonState(
        stem=lesson.stem,
        title=lesson.title,
        minutes=lesson.minutes,
        cells=(len(read), len(lesson.cells)),
        predictions=(min(len(progress.predictions), asked), asked),
        exercise=exercise,
        place=CellToGoOnAt(f"notebooks/{lesson.stem}.ipynb", at.id, at.heading) if at else None,
        touched=progress.touched,
    )


def _after_the_last(cells: tuple[CodeCell, ...], read: set[str]) -> tuple[CodeCell, ...]:
    """The cells after the last one that was read: who skips an experiment goes on behind it."""
    last = max((place for place, one in enumerate(cells) if one.id in read), default=-1)
    return cells[last + 1 :]


@lru_cache(maxsize=256)
def _lesson(path: Path, _mtime: int) -> LessonText:
    cells = json.loads(path.read_text(encoding="utf-8"))["cells"]
    heading, found = "", []
    for cell in cells:
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            heading = [heading, *_HEADING.findall(source)][-1]
        elif cell["cell_type"] == "code":
            asks = _ASKS.search(source)
            found.append(CodeCell(cell["id"], heading.strip(), asks[1] if asks else ""))
    intro = "".join(cells[0]["source"])
    minutes = re.search(r"\*\*Minutes:\*\* *(\d+)", intro)
    title = intro.splitlines()[0].lstrip("# ").strip()
    return LessonText(path.stem, title, minutes[1] if minutes else "", tuple(found))


@lru_cache(maxsize=256)
def _exercise(course: Path, stem: str) -> tuple[str, float]:
    """Title, and the points of the criteria that a student sees."""
    exercise = load_exercise(stem, course)
    return exercise.source.title, sum(one.points for one in exercise.criteria if not one.hidden)
