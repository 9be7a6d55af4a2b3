"""The home page: the course as a map. JupyterLab's server delivers it, `front_end/home/home.js` shows it in a tab.

`make env` registers this module as an extension of the server (workbook/lab/jupyter_files.py).
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
from workbook.lesson.progress import progress_file
from workbook.templating import render

TOUR_SEEN = Path(".state", "tour_seen")
PARTS = (
    (0, "Part one", "From the first node to twelve joints"),
    (10, "Part two", "Time and talk"),
    (14, "Part three", "Python's world"),
    (20, "Part four", "A body"),
)
"""Number of the first lesson, name and title of each part of the course."""


@dataclass(frozen=True)
class Desk:
    """Where a student works, as a Jupyter server sees it. `prefix`: its folder below the server's, as in a link."""

    folder: Path
    prefix: str

    @property
    def answers(self) -> Path:
        """The folder of answers."""
        return self.folder / ANSWERS


def desk_below(root: Path) -> Desk:
    """The student's copy: the server's folder, `work/` in it, or a folder above; else the course's own `work/`."""
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
    """The home page as HTML, to be put into a tab."""
    course = course_map(answers=desk.answers)
    return render(
        "lab/home",
        course=course,
        parts=list(_parts(course)),
        prefix=desk.prefix,
        next=course.next_lesson,
        signs={"done": "✓", "begun": "◐", "open": ""},
    )


def _parts(course: CourseMap) -> Iterable[tuple[str, str, list[Any]]]:
    """Name, title and lessons of each part that has lessons."""
    for (first, name, title), (end, _, _) in zip(PARTS, (*PARTS[1:], (100, "", "")), strict=True):
        lessons = [one for one in course.lessons if first <= int(one.stem[:2]) < end]
        if lessons:
            yield name, title, lessons


def fingerprint(desk: Desk) -> str:
    """Changes whenever the page may have changed: when progress, an answer or its best version was written."""
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
    """What all addresses below `/workbook/` share."""

    def desk(self) -> Desk:
        """Where the student works. Raises web.HTTPError when the course is not there."""
        try:
            return desk_below(Path(self.settings["server_root_dir"]).expanduser())
        except NoCourse as error:
            raise web.HTTPError(404, reason="there is no course here", log_message=str(error)) from error


class HomeHandler(WorkbookHandler):
    """The page, or nothing new (304)."""

    @web.authenticated
    async def get(self) -> None:
        """Answer with the page, or with 304."""
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
    """Puts the best version of an answer back."""

    @web.authenticated
    async def post(self) -> None:
        """Put the best version of the exercise that is named back, and say so."""
        desk = self.desk()
        asked = json.loads(self.request.body or b"{}")
        stem = str(asked.get("exercise", ""))
        if stem not in {one.stem for one in course_map(answers=desk.answers).lessons}:
            raise web.HTTPError(404, reason="there is no such exercise")
        try:
            saved = restore_best(stem, desk.answers)
        except NothingJudged as error:
            raise web.HTTPError(409, reason="nothing was judged yet") from error
        kept = f" The one before is kept as {saved.previous.name}." if saved.previous is not None else ""
        said = (
            f"{ANSWERS}/{stem}.py is your best version again.{kept} "
            f"In the exercise notebook, %restore shows it in the answer cell, too."
        )
        self.finish(json.dumps({"said": said}))


class TourHandler(WorkbookHandler):
    """Whether the tour was seen, and that it was."""

    @web.authenticated
    async def get(self) -> None:
        """Say whether the tour was seen."""
        self.finish(json.dumps({"seen": (self.desk().folder / TOUR_SEEN).exists()}))

    @web.authenticated
    async def post(self) -> None:
        """Note that the tour was seen."""
        file = self.desk().folder / TOUR_SEEN
        file.parent.mkdir(parents=True, exist_ok=True)
        file.touch()
        self.finish("{}")


def _jupyter_server_extension_points() -> list[dict[str, str]]:
    return [{"module": "workbook.lab.home"}]


def _load_jupyter_server_extension(server: Any) -> None:
    base = server.web_app.settings["base_url"]
    handlers = {"home": HomeHandler, "restore": RestoreHandler, "tour": TourHandler}
    server.web_app.add_handlers(
        ".*$", [(url_path_join(base, "workbook", name), handler) for name, handler in handlers.items()]
    )
