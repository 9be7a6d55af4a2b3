"""Find a student's files from any current folder: the course's folder, `work/`, or a folder inside `work/`."""

import os
from pathlib import Path

ANSWERS_VARIABLE = "WORKBOOK_ANSWERS"


def student_answers() -> Path:
    """Return the folder with the student's answers, which may not exist yet. Store it in WORKBOOK_ANSWERS.

    If that variable is already set, return its folder. Otherwise, return `answers/` in the current work folder or,
    failing that, in the course's `work/`. Raises NoCourse.
    """
    from workbook.exercise.answer_files import ANSWERS, answers_folder
    from workbook.exercise.course import course_folder
    from workbook.lab.launch import student_folder

    folder = answers_folder()
    if not os.environ.get(ANSWERS_VARIABLE):
        # An `answers` folder in the course itself contains hand-ins for an instructor to grade. One above the course
        # belongs to something else.
        course = course_folder().resolve()
        if not folder.is_dir() or folder.parent.resolve() in (course, *course.parents):
            folder = student_folder() / ANSWERS
        os.environ[ANSWERS_VARIABLE] = str(folder)
    return folder


def as_typed(path: Path) -> str:
    """Return a path as a user would type it: relative to the current folder if that's shorter."""
    relative = os.path.relpath(path)
    return relative if len(relative) < len(str(path)) else str(path)
