"""Find a student's files, whether the current folder is the course's folder, `work/`, or a folder inside `work/`."""

import os
from pathlib import Path

ANSWERS_VARIABLE = "WORKBOOK_ANSWERS"


def student_answers() -> Path:
    """Return the folder for the student's answers, which may not exist yet. Store its path in WORKBOOK_ANSWERS.

    If that environment variable is already set, return the folder that it names. Otherwise, return `answers/` in the
    current work folder or, failing that, in the course's `work/`. Raises NoCourse if the course can't be found.
    """
    from workbook.exercise.answer_files import ANSWERS, answers_folder
    from workbook.exercise.course import course_folder
    from workbook.lab.launch import student_folder

    folder = answers_folder()
    if not os.environ.get(ANSWERS_VARIABLE):
        # An `answers` folder in the course itself contains hand-ins for an instructor to grade. An `answers` folder
        # above the course doesn't belong to the course.
        course = course_folder().resolve()
        if not folder.is_dir() or folder.parent.resolve() in (course, *course.parents):
            folder = student_folder() / ANSWERS
        os.environ[ANSWERS_VARIABLE] = str(folder)
    return folder


def as_typed(path: Path) -> str:
    """Return a path as a user would type it: relative to the current folder if that's shorter."""
    relative = os.path.relpath(path)
    return relative if len(relative) < len(str(path)) else str(path)
