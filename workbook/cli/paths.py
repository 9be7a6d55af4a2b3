"""Where a student's files are, from wherever the command was typed: the course's folder, `work/`, or below it."""

import os
from pathlib import Path

ANSWERS_VARIABLE = "WORKBOOK_ANSWERS"


def student_answers() -> Path:
    """The folder of the student's answers, whether it exists or not; the rest of this process looks there, too.

    It is the folder that the environment names, else `answers/` of the work folder that one stands in, else that of the
    course's `work/`. Raises NoCourse.
    """
    from workbook.exercise.answer_files import ANSWERS, answers_folder
    from workbook.exercise.course import course_folder
    from workbook.lab.launch import student_folder

    folder = answers_folder()
    if not os.environ.get(ANSWERS_VARIABLE):
        # An `answers` folder of the course itself is an instructor's, who grades it. One above it is another's.
        course = course_folder().resolve()
        if not folder.is_dir() or folder.parent.resolve() in (course, *course.parents):
            folder = student_folder() / ANSWERS
        os.environ[ANSWERS_VARIABLE] = str(folder)
    return folder


def as_typed(path: Path) -> str:
    """A path as one would type it here: relative where that is shorter."""
    relative = os.path.relpath(path)
    return relative if len(relative) < len(str(path)) else str(path)
