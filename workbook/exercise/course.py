"""Where the course is: its exercises, criteria and solutions."""

import os
from pathlib import Path


class NoCourse(RuntimeError):
    """The folder of the course was not found."""


def course_folder() -> Path:
    """The folder that holds `exercises/` and `solutions/`.

    WORKBOOK_COURSE names it; otherwise it is the checkout that the package was installed from. Raises NoCourse.
    """
    named = os.environ.get("WORKBOOK_COURSE")
    folder = Path(named) if named else Path(__file__).resolve().parents[2]
    if not (folder / "exercises" / "criteria").is_dir():
        raise NoCourse(
            f"{folder} holds no exercises/criteria. Run this in the environment that `make env` made in the "
            "course's folder, or set WORKBOOK_COURSE to that folder."
        )
    return folder
