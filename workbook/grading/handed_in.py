"""Store which students have handed in an answer, so that exports can leave out students whose hand-in is gone."""

import csv
import io
from collections.abc import Collection, Iterable
from pathlib import Path

from workbook.grading.files import write_whole
from workbook.grading.results import Result

HANDED_IN = "handed_in.csv"
HEADER = ["student", "exercise"]


def note(out: Path, exercise: str, students: Collection[str], *, whole: bool) -> None:
    """Store which students have handed in an answer for `exercise`.

    `whole`: whether the list is complete. If it isn't, the students are added to the list from earlier runs, or nothing
    is stored if there is no earlier list.
    """
    before = _read(out)
    if not whole and all(listed != exercise for _, listed in before):
        return
    kept = {pair for pair in before if pair[1] != exercise or not whole}
    table = io.StringIO()
    writer = csv.writer(table, lineterminator="\n")
    writer.writerows([HEADER, *sorted(kept | {(student, exercise) for student in students})])
    write_whole(out / HANDED_IN, table.getvalue())


def with_a_hand_in(out: Path, results: Iterable[Result]) -> list[Result]:
    """Return the results except those whose hand-in no longer exists.

    If there's no list of an exercise's hand-ins, keep all of its results.
    """
    pairs = _read(out)
    listed = {exercise for _, exercise in pairs}
    return [one for one in results if one.exercise not in listed or one.key in pairs]


def _read(out: Path) -> set[tuple[str, str]]:
    path = out / HANDED_IN
    if not path.is_file():
        return set()
    with path.open(encoding="utf-8-sig", errors="surrogateescape", newline="") as file:
        return {(row[0], row[1]) for row in csv.reader(file) if len(row) == 2 and row != HEADER}
