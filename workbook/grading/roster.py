"""Whose a hand-in is: the names that an instructor has for students and for the exercise."""

import csv
from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, field, replace
from pathlib import Path

from workbook.grading.hand_ins import HandIn, one_for_each, one_spelling


class BadOption(ValueError):
    """An option or a file that comes with it cannot be used. The message says why."""


@dataclass(frozen=True)
class Roster:
    """`aliases`: the student by the name of a file or folder. `assignment`: what nbgrader calls the exercise."""

    aliases: Mapping[str, str] = field(default_factory=dict)
    assignment: str | None = None

    def hand_ins(self, found: Sequence[HandIn]) -> list[HandIn]:
        """One hand-in for each student, under the name that the aliases give it, sorted.

        Refused are two hand-ins of one student, one that aliases give to two students, and one whose name is that of
        a student other than the one that an alias gives it to.
        """
        students = set(self.aliases.values())
        students |= {one.student for one in found if not self._owners(one)}
        return one_for_each([mine for one in found for mine in self._given(one, students)])

    def unused(self, found: Sequence[HandIn]) -> list[str]:
        """Names in the aliases that are the name of no hand-in."""
        names = {name for one in found for name in _names(one)}
        return [name for name in self.aliases if name not in names]

    def _owners(self, hand_in: HandIn) -> list[str]:
        return list(dict.fromkeys(self.aliases[name] for name in _names(hand_in) if name in self.aliases))

    def _given(self, hand_in: HandIn, students: Set[str]) -> list[HandIn]:
        """The hand-in under the name of its student; refused for each of them where there are several."""
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
    """What an alias may call a hand-in: its whole path, or the name of the file or folder at the top.

    Names further down are a student's own choice, who could choose one that is an alias of somebody else.
    """
    label = one_spelling(hand_in.label)
    return label, *Path(label).parts[:1], hand_in.student


def about_unused(names: Sequence[str]) -> str:
    """A sentence on aliases that fit nothing, the first of many by name; empty where all fit."""
    if not names:
        return ""
    what = "1 alias fits" if len(names) == 1 else f"{len(names)} aliases fit"
    told = ", ".join(names[:5]) + (", …" if len(names) > 5 else "")
    return f"{what} no hand-in: {told}. An alias is a whole path, or the name of a file or folder at the top"


def read_aliases(path: Path) -> dict[str, str]:
    """Who a file or folder belongs to: a CSV with two columns, file or folder name and student. Raises BadOption."""
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
