"""Create each student's folders, with their permissions, and assign user IDs.

FOLDER/students/NAME/work     notebooks and progress: the student's alone
FOLDER/students/NAME/home     settings, tokens and history: the student's alone
FOLDER/hand_ins/NAME          the student's work/answers, which instructors read
FOLDER/published/NAME         the student's work/feedback, which instructors write
"""

import os
from dataclasses import dataclass
from pathlib import Path

ANSWERS = "answers"
FEEDBACK = "feedback"
STUDENTS = "students"
HAND_INS = "hand_ins"
PUBLISHED = "published"


@dataclass(frozen=True)
class Place:
    """A student's folders under the class folder `top`.

    `user`: the student's ID as user and as group. `instructors`: the group ID of all instructors.
    """

    name: str
    user: int
    instructors: int
    top: Path

    @property
    def work(self) -> Path:
        """The folder for notebooks and progress."""
        return self.top / STUDENTS / self.name / "work"

    @property
    def home(self) -> Path:
        """The folder for everything else that belongs to the student."""
        return self.top / STUDENTS / self.name / "home"

    @property
    def passwd(self) -> Path:
        """The file that the student's programs see as /etc/passwd."""
        return self.top / STUDENTS / self.name / "passwd"

    @property
    def hand_ins(self) -> Path:
        """The folder for answers. It appears in the student's work folder."""
        return self.top / HAND_INS / self.name

    @property
    def published(self) -> Path:
        """The folder for an instructor's pages. It appears in the student's work folder."""
        return self.top / PUBLISHED / self.name


def place_of(name: str, top: Path, first_id: int) -> Place:
    """Find or create a student's folders. The owner of `home` permanently determines the user ID.

    `first_id` is the instructors' group ID. A new student gets the highest ID in use plus one.
    """
    for folder in (top, top / STUDENTS, top / HAND_INS, top / PUBLISHED):
        folder.mkdir(parents=True, exist_ok=True)
        _give(folder, 0, first_id, 0o750)
    place = Place(name, _user_id(top / STUDENTS, name, first_id), first_id, top)
    if not place.passwd.exists():  # this file is written last
        _make(place)
    return place


def _user_id(students: Path, name: str, first_id: int) -> int:
    try:
        return (students / name / "home").stat().st_uid
    except FileNotFoundError:
        taken = [home.stat().st_uid for home in students.glob("*/home")]
        return max([first_id, *taken]) + 1


def _make(place: Place) -> None:
    """Create a new student's folders. The student had no access to them before, and can't have put anything there."""
    for folder, user, mode in (
        (place.home.parent, 0, 0o700),
        (place.hand_ins, place.user, 0o2750),  # new files belong to the instructors' group
        (place.published, 0, 0o2775),  # instructors write; others can't enter the parent folder
        (place.work, place.user, 0o700),
        (place.work / ANSWERS, place.user, 0o700),  # `hand_ins` is mounted there
        (place.work / FEEDBACK, 0, 0o755),  # and `published` there
        (place.home, place.user, 0o700),
    ):
        folder.mkdir(exist_ok=True)
        _give(folder, user, place.instructors, mode)
    line = f"{place.name}:x:{place.user}:{place.user}::/home/{place.name}:/bin/bash\n"
    place.passwd.write_text(line, encoding="utf-8")


def _give(folder: Path, user: int, group: int, mode: int) -> None:
    os.chown(folder, user, group)
    os.chmod(folder, mode)
