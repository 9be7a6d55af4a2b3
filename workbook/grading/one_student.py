"""Find all data that a gradebook stores about one student, and export or erase the data.

This includes the data under all names that look like the student's name, because `é` may be one character or two.
"""

import csv
import json
import os
import unicodedata
import zipfile
from collections.abc import Callable, Iterator, Sequence, Set
from contextlib import contextmanager
from dataclasses import dataclass, replace
from difflib import get_close_matches
from pathlib import Path
from typing import TypeVar

from workbook.exercise.definition import Exercise, load_exercise
from workbook.grading.appeals import OVERRIDES, kept, with_changes
from workbook.grading.changes import Override
from workbook.grading.class_page import class_page
from workbook.grading.files import write_whole
from workbook.grading.gradebook import GRADES
from workbook.grading.grades_csv import cells_of, student_cell
from workbook.grading.handed_in import HANDED_IN
from workbook.grading.pages import CLASS, PAGES, page_name
from workbook.grading.results import Result, StudentAndExercise
from workbook.grading.results_file import RESULTS, ResultsFile, result_of
from workbook.recording.codec import decode

Read = TypeVar("Read")

TABLES = {
    GRADES: "student",
    "canvas.csv": "SIS Login ID",
    "moodle.csv": "ID number",
    "nbgrader.csv": "student_id",
}
"""The tables of a gradebook, each with the name of the column that identifies the student."""


class NotErasable(ValueError):
    """Raised when a gradebook can't be read or a student can't be found in it. The message says why, and what to do."""


@dataclass(frozen=True)
class Lines:
    """The lines of a text file: `mine` are about the student, `others` are all other lines.

    `head`: a table's header.
    """

    path: Path
    mine: tuple[str, ...]
    others: tuple[str, ...]
    head: str = ""


@dataclass(frozen=True)
class Holdings:
    """The data that a gradebook stores about a student, under all `names` that look like the student's name.

    `results`: the student's results, one per attempt. `lines`: the lines of results.jsonl, overrides.jsonl, the tables,
    and the instructor's own lists. `files`: pages and recordings that belong only to this student. `shared`: recordings
    that other students' results also need. `others`: the other students' current results.
    """

    out: Path
    names: tuple[str, ...]
    results: tuple[Result, ...]
    lines: tuple[Lines, ...]
    files: tuple[Path, ...]
    shared: tuple[Path, ...]
    others: dict[StudentAndExercise, Result]

    @property
    def answers(self) -> tuple[str, ...]:
        """The original paths of the hand-ins, which aren't part of the gradebook."""
        return tuple(sorted({one.answer for one in self.results}))


@contextmanager
def holdings(out: Path, student: str, lists: Sequence[Path] = ()) -> Iterator[Holdings]:
    """Find all data about a student in the gradebook `out`. Keep the gradebook locked until the `with` block is left.

    `lists`: the instructor's CSV files that name students, such as aliases. Raises NotErasable, or FolderInUse if
    another run is using the gradebook.
    """
    path = out / RESULTS
    if not path.is_file():
        raise NotErasable(f"{out} holds no {RESULTS}, so it is no gradebook")
    if _is_torn(path) or _is_torn(out / OVERRIDES):
        raise NotErasable(
            f"the last line of a file in {out} is incomplete: a run is at work, or was killed. Wait for it, or run "
            "`workbook grade` again, and then repeat this command"
        )
    with ResultsFile(path):
        yield _found(out, student, lists)


def _is_torn(path: Path) -> bool:
    return path.is_file() and path.stat().st_size > 0 and not path.read_bytes().endswith(b"\n")


def _alike(name: str) -> str:
    return unicodedata.normalize("NFC", name).strip()


def _text(path: Path) -> str:
    """Return a file's content unchanged, including line endings and undecodable bytes."""
    return path.read_bytes().decode("utf-8", "surrogateescape")


def _found(out: Path, student: str, lists: Sequence[Path]) -> Holdings:
    pairs = [(line, _whole(result_of, out / RESULTS, n, line)) for n, line in _numbered(_text(out / RESULTS))]
    changes = _text(out / OVERRIDES) if (out / OVERRIDES).is_file() else ""
    by_hand = [(line, _whole(_change_of, out / OVERRIDES, n, line)) for n, line in _numbered(changes)]
    tables = [out / name for name in TABLES if (out / name).is_file()]
    handed_in = [path for path in (out / HANDED_IN,) if path.is_file()]
    known = sorted({one.student for _, one in pairs} | {one.student for _, one in by_hand})
    names = _names_of(student, known)
    mine = tuple(one for _, one in pairs if one.student in names)
    theirs = [one for _, one in pairs if one.student not in names]
    own, needed = _recordings(out, mine), _recordings(out, theirs)
    lines = [
        _split(out / RESULTS, pairs, names),
        _split(out / OVERRIDES, by_hand, names),
        *(_rows(path, _cells(names), TABLES[path.name]) for path in tables),
        *(_rows(path, {_alike(name) for name in names}) for path in (*lists, *handed_in)),
    ]
    return Holdings(
        out=out,
        names=names,
        results=mine,
        lines=tuple(one for one in lines if one.mine),
        files=tuple(path for path in (*_pages(out, names), *sorted(own - needed)) if path.is_file()),
        shared=tuple(sorted(own & needed)),
        others={one.key: one for one in theirs},
    )


def _numbered(text: str) -> list[tuple[int, str]]:
    return list(enumerate((line + "\n" for line in text.split("\n")[:-1]), start=1))


def _whole(read: Callable[[str], Read], path: Path, number: int, line: str) -> Read:
    """Parse a line. Raises NotErasable if the line is invalid, because then it could be about this student."""
    try:
        return read(line)
    except (ValueError, RecursionError) as error:
        raise NotErasable(
            f"{path}, line {number}, cannot be read ({error}), so it can't be matched to a student: "
            "restore it, or delete it"
        ) from error


def _change_of(line: str) -> Override:
    change: Override = decode(Override, json.loads(line))
    return change


def _names_of(student: str, known: Sequence[str]) -> tuple[str, ...]:
    """Return all known names that look like `student`, or that tables show as `student`.

    Raises NotErasable if there are none.
    """
    names = [one for one in known if _alike(one) == _alike(student) or student.strip() == student_cell(one)]
    if names:
        return tuple(names)
    cells = {student_cell(one).casefold(): student_cell(one) for one in known}
    near = [cells[one] for one in get_close_matches(student.casefold(), cells, n=3, cutoff=0.6)]
    guess = f" Similar names: {', '.join(near)}." if near else ""
    raise NotErasable(f"this gradebook knows no student {student}.{guess} Write the name as grades.csv does")


def _cells(names: Sequence[str]) -> set[str]:
    return {_alike(cell) for name in names for cell in cells_of(name)}


def _recordings(out: Path, results: Sequence[Result]) -> set[Path]:
    """Return the paths of these results' recordings, except paths outside of the recordings' folder."""
    folder = (out / "recordings").resolve()
    names = {name for one in results for name in (one.recording, *(a.recording for a in one.tries)) if name}
    return {out / name for name in names if (out / name).resolve().parent == folder}


def _pages(out: Path, names: Sequence[str]) -> list[Path]:
    ends = [page_name(name, "") for name in names]
    found = [path for end in ends for path in (out / PAGES).glob(f"*{end}")]
    scope = [end.removesuffix(".html") for end in ends]
    return sorted(found + [path for end in scope for path in (out / "gradescope").glob(f"*{end}.json")])


def _split(path: Path, pairs: Sequence[tuple[str, Result | Override]], names: Sequence[str]) -> Lines:
    return Lines(
        path,
        tuple(line for line, one in pairs if one.student in names),
        tuple(line for line, one in pairs if one.student not in names),
    )


def _rows(path: Path, cells: Set[str], column: str | None = None) -> Lines:
    """Split a CSV file's rows by whether they name the student in `column`, or anywhere if `column` is None."""
    try:
        text = _text(path)
    except OSError as error:
        raise NotErasable(f"{path} cannot be read: {error.strerror}") from error
    physical = text.splitlines(keepends=True)
    reader = csv.reader(physical)
    mine, others, head, at, place = [], [], "", 0, None
    for row in reader:
        raw, at = "".join(physical[at : reader.line_num]), reader.line_num
        plain = [_alike(cell.removeprefix("\ufeff")) for cell in row]
        if column is not None and not head:
            head, place = raw, plain.index(column) if column in plain else None
            others.append(raw)
        elif any(cell in cells for cell in (plain if place is None else plain[place : place + 1])):
            mine.append(raw)
        else:
            others.append(raw)
    return Lines(path, tuple(mine), tuple(others), head)


# --- exported and erased ----------------------------------------------------------------------------------------------


def export(found: Holdings, archive: Path) -> Path:
    """Pack all data about the student into a new zip file. Raises NotErasable if that file already exists."""
    if archive.exists():
        raise NotErasable(f"{archive} is there already: name a new file with --to")
    partial = archive.with_name(f".{archive.name}.part")
    try:
        with zipfile.ZipFile(partial, "w", zipfile.ZIP_DEFLATED) as zipped:
            for number, one in enumerate(found.lines):
                text = one.head + "".join(one.mine)
                name = one.path.name if one.path.parent == found.out else f"lists/{number}-{one.path.name}"
                zipped.writestr(name, text.encode("utf-8", "surrogateescape"))
            for path in (*found.files, *(path for path in found.shared if path.is_file())):
                zipped.write(path, path.relative_to(found.out))
        partial.replace(archive)
    finally:
        partial.unlink(missing_ok=True)
    return archive


def erase(found: Holdings, load: Callable[[str], Exercise] = load_exercise) -> list[str]:
    """Erase all data about the student, and rebuild the class page. Return sentences about problems.

    The student's results are erased last. So if this function is interrupted, calling it again still finds the
    remaining data.
    """
    said = _rebuild_class_page(found, load)
    for path in found.files:
        path.unlink(missing_ok=True)
    for one in sorted(found.lines, key=lambda one: one.path.name == RESULTS):
        _replace(one.path, "".join(one.others))
    return said


def _replace(path: Path, text: str) -> None:
    partial = path.with_name(f".{path.name}.part")
    with partial.open("wb") as file:
        file.write(text.encode("utf-8", "surrogateescape"))
        file.flush()
        os.fsync(file.fileno())
    partial.replace(path)


def _rebuild_class_page(found: Holdings, load: Callable[[str], Exercise]) -> list[str]:
    """Rewrite the class page without this student. The other students' scores come from grades.csv."""
    path = found.out / PAGES / CLASS
    if not path.is_file():
        return []
    page = _text(path)
    shown = [stem for stem in {one.exercise for one in found.results} if f'href="{stem}-' in page]
    if not shown:
        return []
    rest = _as_in_tables(found, with_changes(found.others.values(), kept(found.out)))
    try:
        exercise = load(shown[0])
    except (LookupError, RuntimeError, OSError) as error:
        path.unlink()
        return [f"{path} was removed, because it cannot be written again: {error}"]
    write_whole(path, class_page([one for one in rest if one.exercise == exercise.stem], exercise))
    return []


def _as_in_tables(found: Holdings, results: Sequence[Result]) -> list[Result]:
    """Return the results with the scores from grades.csv, because results.jsonl doesn't store late penalties."""
    scores: dict[tuple[str, str], float] = {}
    if (found.out / GRADES).is_file():
        for row in csv.DictReader(_text(found.out / GRADES).removeprefix("\ufeff").splitlines()):
            if row.get("score"):
                scores[row["student"], row["exercise"]] = float(row["score"])
    listed = []
    for one in results:
        score = scores.get((student_cell(one.student), one.exercise), one.score)
        late = 0.0 if one.score is None or score is None else max(0.0, one.score - score)
        listed.append(replace(one, score=score, late_points=late) if late else one)
    return listed
