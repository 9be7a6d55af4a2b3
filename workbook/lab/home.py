"""Serve the home page, a map of the course. `front_end/home/home.js` shows it in a JupyterLab tab.

`make env` registers this module as a server extension (workbook/lab/jupyter_files.py).
"""

import asyncio
import hashlib
import json
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from jupyter_server.base.handlers import JupyterHandler
from jupyter_server.utils import url_path_join
from tornado import web

from workbook.exercise.course import NoCourse, course_folder
from workbook.exercise.definition import BrokenCriteria
from workbook.lab.work_folder import ANSWERS, STATE
from workbook.lesson.best_answers import BEST, NothingJudged, restore_best
from workbook.lesson.course_map import CourseMap, course_map
from workbook.lesson.progress import LessonProgress, all_progress, progress_file
from workbook.lesson.sealed_predictions import all_predictions
from workbook.templating import render

TOUR_SEEN = Path(".state", "tour_seen")
PARTS = (
    (0, "Part one", "From the first node to twelve joints"),
    (10, "Part two", "Time and talk"),
    (14, "Part three", "Python's world"),
    (20, "Part four", "A body"),
)
"""For each part of the course: the number of its first lesson, its name, and its title."""
MOST_MISSING = 4
"""If at most this many cells are left to read in a lesson, the page links to them."""


@dataclass(frozen=True)
class Desk:
    """A student's work folder. `prefix`: its path relative to the Jupyter server's root, as used in links."""

    folder: Path
    prefix: str

    @property
    def answers(self) -> Path:
        """The folder with the student's answers."""
        return self.folder / ANSWERS


def desk_below(root: Path) -> Desk:
    """Find the student's copy of the course: the server's root folder, its `work/`, or one of its parent folders.

    If none of these folders is a copy, use the course's `work/`. If that isn't a copy either, use the course folder.
    """
    root = root.resolve()
    course = course_folder().resolve()
    for folder in (root, root / "work", *root.parents, course / "work"):
        if (folder / STATE).is_file():
            break
    else:
        folder = course
    try:
        relative = folder.relative_to(root).as_posix()
    except ValueError:
        relative = "."
    return Desk(folder, "" if relative == "." else f"{relative}/")


def page(desk: Desk) -> str:
    """Render the home page as HTML."""
    course = course_map(answers=desk.answers)
    return render(
        "lab/home",
        course=course,
        parts=list(_parts(course)),
        prefix=desk.prefix,
        next=course.next_lesson,
        most_missing=MOST_MISSING,
        signs={"done": "✓", "begun": "◐", "open": ""},
    )


def _parts(course: CourseMap) -> Iterable[tuple[str, str, list[Any]]]:
    """Yield the name, title, and lessons of each part that has lessons."""
    for (first, name, title), (end, _, _) in zip(PARTS, (*PARTS[1:], (100, "", "")), strict=True):
        lessons = [one for one in course.lessons if first <= int(one.stem[:2]) < end]
        if lessons:
            yield name, title, lessons


def fingerprint(desk: Desk) -> str:
    """Return a value that changes whenever the page may have changed.

    It changes when progress, an answer, a best version, or a lesson is written.
    """
    course = course_folder()
    files = [
        progress_file(desk.answers),
        *sorted(desk.answers.glob("[0-9]*.py")),
        *sorted((desk.answers / BEST).glob("*.py")),
        *sorted((course / "notebooks").glob("[0-9]*.ipynb")),
    ]
    digest = hashlib.sha256(desk.prefix.encode())
    for file in files:
        try:
            state = file.stat()
        except OSError:
            continue
        digest.update(f"{file} {state.st_mtime_ns} {state.st_size}\n".encode())
    return digest.hexdigest()


class WorkbookHandler(JupyterHandler):
    """Base class of the handlers for addresses below `/workbook/`."""

    def desk(self) -> Desk:
        """Return the student's work folder. Raise web.HTTPError if there is no course."""
        try:
            return desk_below(Path(self.settings["server_root_dir"]).expanduser())
        except NoCourse as error:
            raise web.HTTPError(404, reason="there is no course here", log_message=str(error)) from error


class HomeHandler(WorkbookHandler):
    """Handles requests for the home page."""

    @web.authenticated
    async def get(self) -> None:
        """Send the page, or status 304 if it hasn't changed."""
        desk = self.desk()
        tag = f'"{fingerprint(desk)}"'
        self.set_header("Cache-Control", "no-cache")
        self.set_header("Content-Type", "text/html; charset=utf-8")
        self.set_header("Etag", tag)
        if self.request.headers.get("If-None-Match") == tag:
            self.set_status(304)
            self.finish()
            return
        try:
            html = await asyncio.get_running_loop().run_in_executor(None, page, desk)
        except (BrokenCriteria, OSError, ValueError, KeyError) as error:
            html = render("lab/home_problem", problem=str(error))
        self.finish(html)


class RestoreHandler(WorkbookHandler):
    """Handles requests to restore the best version of an answer."""

    @web.authenticated
    async def post(self) -> None:
        """Restore the best version of the named exercise's answer and send a confirmation."""
        desk = self.desk()
        asked = json.loads(self.request.body or b"{}")
        stem = str(asked.get("exercise", ""))
        if stem not in {one.stem for one in course_map(answers=desk.answers).lessons}:
            raise web.HTTPError(404, reason="there is no such exercise")
        try:
            saved = restore_best(stem, desk.answers)
        except NothingJudged as error:
            raise web.HTTPError(409, reason="nothing has been judged yet") from error
        kept = (
            f" The previous version is kept as {saved.previous.name}." if saved.previous is not None else ""
        )
        said = (
            f"{ANSWERS}/{stem}.py is your best version again.{kept} "
            f"In the exercise notebook, %restore shows it in the answer cell, too."
        )
        self.finish(json.dumps({"said": said}))


class PredictionsHandler(WorkbookHandler):
    """Handles requests for a lesson's predictions: the student's choices, and only the outcomes already shown."""

    @web.authenticated
    async def get(self) -> None:
        """Send two dictionaries, `choices` and `outcomes`, which map a prediction's name to a letter."""
        progress = all_progress(self.desk().answers).get(
            self.get_query_argument("lesson", ""), LessonProgress()
        )
        choices = progress.predictions
        known = all_predictions() if progress.outcomes_seen else {}
        outcomes = {
            name: known[name].usual for name in progress.outcomes_seen if name in known and name in choices
        }
        self.finish(json.dumps({"choices": choices, "outcomes": outcomes}))


class TourHandler(WorkbookHandler):
    """Handles requests to store or report whether the student has seen the tour."""

    @web.authenticated
    async def get(self) -> None:
        """Send whether the student has seen the tour."""
        self.finish(json.dumps({"seen": (self.desk().folder / TOUR_SEEN).exists()}))

    @web.authenticated
    async def post(self) -> None:
        """Record that the student has seen the tour."""
        file = self.desk().folder / TOUR_SEEN
        file.parent.mkdir(parents=True, exist_ok=True)
        file.touch()
        self.finish("{}")


def _jupyter_server_extension_points() -> list[dict[str, str]]:
    return [{"module": "workbook.lab.home"}]


def _load_jupyter_server_extension(server: Any) -> None:
    base = server.web_app.settings["base_url"]
    handlers = {
        "home": HomeHandler,
        "restore": RestoreHandler,
        "tour": TourHandler,
        "predictions": PredictionsHandler,
    }
    server.web_app.add_handlers(
        ".*$", [(url_path_join(base, "workbook", name), handler) for name, handler in handlers.items()]
    )
