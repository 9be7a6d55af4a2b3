"""Match hand-ins to students, using the instructor's names for students and for the exercise."""

import csv
from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, field, replace
from pathlib import Path

from workbook.grading.hand_ins import HandIn, one_for_each, one_spelling


class BadOption(ValueError):
    """Raised when an option, or a file that an option names, can't be used. The message says why."""


@dataclass(frozen=True)
class Roster:
    """The instructor's names for students and for the exercise.

    `aliases`: maps file and folder names to students. `assignment`: the exercise's name in nbgrader.
    """

    aliases: Mapping[str, str] = field(default_factory=dict)
    assignment: str | None = None

    def hand_ins(self, found: Sequence[HandIn]) -> list[HandIn]:
        """Return one hand-in per student, sorted, with the student's name from the aliases.

        If a student has several hand-ins, all of them are rejected. A hand-in is also rejected if aliases assign it to
        two students. It's rejected, too, if it's named after one student but an alias assigns it to another.
        """
        students = set(self.aliases.values())
        students |= {one.student for one in found if not self._owners(one)}
        return one_for_each([mine for one in found for mine in self._given(one, students)])

    def unused(self, found: Sequence[HandIn]) -> list[str]:
        """Return the aliases that don't match any hand-in."""
        names = {name for one in found for name in _names(one)}
        return [name for name in self.aliases if name not in names]

    def _owners(self, hand_in: HandIn) -> list[str]:
        return list(dict.fromkeys(self.aliases[name] for name in _names(hand_in) if name in self.aliases))

    def _given(self, hand_in: HandIn, students: Set[str]) -> list[HandIn]:
        """Return the hand-in under its student's name.

        If aliases make it unclear which of several students the hand-in belongs to, return a rejected hand-in for each
        of these students.
        """
        owners = self._owners(hand_in)
        if not owners:
            return [hand_in]
        if len(owners) > 1:
            problem = f"aliases give it to {' and to '.join(owners)}: leave one of these lines"
        elif hand_in.student in students - {owners[0]}:
            problem = (
                f"{hand_in.label} is {hand_in.student}'s by its name and {owners[0]}'s by an alias: correct the "
                "alias, or rename the file"
            )
            owners = [owners[0], hand_in.student]
        else:
            return [replace(hand_in, student=owners[0])]
        return [replace(hand_in, student=owner, problem=problem) for owner in owners]


def _names(hand_in: HandIn) -> tuple[str, ...]:
    """Return the names by which an alias may refer to a hand-in: its path, or its name at the top level.

    Names of files and folders further down don't count, because students choose these, and one of them could choose the
    name in another student's alias.
    """
    label = one_spelling(hand_in.label)
    return label, *Path(label).parts[:1], hand_in.student


def about_unused(names: Sequence[str]) -> str:
    """Return a sentence about unused aliases that names the first few, or "" if there are none."""
    if not names:
        return ""
    what = "1 alias fits" if len(names) == 1 else f"{len(names)} aliases fit"
    told = ", ".join(names[:5]) + (", …" if len(names) > 5 else "")
    return f"{what} no hand-in: {told}. An alias is a whole path, or the name of a file or folder at the top"


def read_aliases(path: Path) -> dict[str, str]:
    """Read aliases from a CSV file with two columns: file or folder name, and student.

    Raises BadOption if a line is invalid.
    """
    aliases: dict[str, str] = {}
    try:
        with path.open(encoding="utf-8-sig", newline="") as file:
            for number, row in enumerate(csv.reader(file), start=1):
                if not any(cell.strip() for cell in row):
                    continue
                if len(row) < 2 or not row[0].strip() or not row[1].strip():
                    raise BadOption(f"{path}, line {number}: a line is `file or folder,student`")
                name, student = one_spelling(row[0].strip()), one_spelling(row[1].strip())
                if aliases.get(name, student) != student:
                    raise BadOption(f"{path}, line {number}: {name} belongs to two students")
                aliases[name] = student
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise BadOption(f"{path}: {error}") from error
    return aliases
