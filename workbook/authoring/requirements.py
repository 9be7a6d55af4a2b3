"""Requirements tables, which link each requirement of a task to the criteria that judge it.

The tables also link each requirement to the wrong answers that violate it. They are stored in
`tests/requirements/NN_slug.toml`. A requirement has an `id` and a `sentence` (or several), quoted from the task. It
also has either `criteria` and `wrong` answers, or `not_judged` with the reason.
"""

import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import Any, TypeGuard

from workbook.authoring.demands import untied_demands
from workbook.authoring.task_text import folded, missing_words, task_text
from workbook.authoring.tree import Tree, entries
from workbook.authoring.violations import Violation, line_of
from workbook.authoring.wrong_answers import WrongAnswerError, read_header
from workbook.exercise.definition import Exercise
from workbook.feedback.wording import points

WITHOUT_TABLE: frozenset[str] = frozenset()
"""Exercises that may lack a table, because they are older than this rule. Don't add any."""
KEYS = ("id", "sentence", "criteria", "wrong", "not_judged")

_MISSING = (
    "is missing: write a [[requirement]] for each demand of the task, with id, sentence, criteria and wrong; "
    "see 'The requirements' in docs/exercises.md"
)
_ID = re.compile(r"[a-z0-9]+(-[a-z0-9]+)*")
_ROW = re.compile(r"\s*\[\[\s*requirement\s*\]\]")
_AT_LINE = re.compile(r"\(at line (\d+), column \d+\)")


@dataclass(frozen=True)
class Requirement:
    """One requirement of a task. Fields that the table leaves out are empty. `row` is its position, counted from 0."""

    row: int
    id: str
    sentences: tuple[str, ...]
    criteria: tuple[str, ...]
    wrong: tuple[str, ...]
    not_judged: str

    @property
    def title(self) -> str:
        """The requirement's name in messages to its author."""
        return f"requirement {self.id!r}" if self.id else f"requirement {self.row + 1}"


@dataclass(frozen=True)
class TableFile:
    """A table's lines, for finding the line numbers in messages. `name` is the path that messages show."""

    name: str
    lines: tuple[str, ...]

    def at(self, row: int, pattern: str, words: str) -> Violation:
        """Return a violation at a row's first line that matches the pattern.

        If no line matches, use the row's first line. If the row isn't a [[requirement]] block, use the whole file.
        """
        starts = [number for number, line in enumerate(self.lines, start=1) if _ROW.match(line)]
        if row >= len(starts):  # the rows are written as an array of inline tables
            return Violation(self.name, words)
        end = starts[row + 1] if row + 1 < len(starts) else len(self.lines) + 1
        block = range(starts[row], end)
        line = next((one for one in block if re.search(pattern, self.lines[one - 1])), starts[row])
        return Violation(self.name, words, line)

    def at_key(self, row: int, key: str, words: str) -> Violation:
        """Return a violation at a row's key."""
        return self.at(row, rf"^\s*[\"']?{re.escape(key)}[\"']?\s*=", words)

    def at_text(self, row: int, text: str, words: str) -> Violation:
        """Return a violation at the line of a row in which a text begins."""
        first = next((line.strip() for line in text.splitlines() if line.strip()), "")
        return self.at(row, re.escape(first[:30]), words)

    def at_name(self, row: int, name: str, words: str) -> Violation:
        """Return a violation at the name of a criterion or a wrong answer in a row."""
        return self.at(row, rf"[\"']{re.escape(name)}[\"']", words)


def stale_exceptions(tree: Tree, without: frozenset[str] = WITHOUT_TABLE) -> Iterator[Violation]:
    """Yield a violation for each exercise in `without` that doesn't exist or that does have a table."""
    module, root = Path(__file__).resolve(), tree.root.resolve()
    if not module.is_relative_to(root):  # WITHOUT_TABLE applies only to this module's own course
        return
    text = module.read_text(encoding="utf-8")
    for stem in sorted(without):
        if stem not in tree.exercise_stems():
            words = f"WITHOUT_TABLE names {stem}, but there is no such exercise: delete it here"
        elif (tree.requirements / f"{stem}.toml").is_file():
            words = f"WITHOUT_TABLE names {stem}, which has a table now: delete it here"
        else:
            continue
        yield Violation(module.relative_to(root).as_posix(), words, line_of(text, f'"{stem}"'))


def table_violations(
    tree: Tree, stem: str, exercise: Exercise | None, without: frozenset[str] = WITHOUT_TABLE
) -> Iterator[Violation]:
    """Yield a violation for each error in an exercise's table, or if the table is missing.

    If the exercise couldn't be read (`exercise` is None), skip the checks that need it.
    """
    path = tree.requirements / f"{stem}.toml"
    name = tree.name(path)
    if not path.is_file():
        if stem not in without:
            yield Violation(name, _MISSING)
        return
    try:
        text = path.read_text(encoding="utf-8")
        data = tomllib.loads(text)
    except UnicodeDecodeError as error:
        yield Violation(name, f"is not UTF-8 ({error.reason} at byte {error.start}): save it as UTF-8")
        return
    except tomllib.TOMLDecodeError as error:
        found = _AT_LINE.search(str(error))
        yield Violation(name, f"is not TOML: {error}", int(found[1]) if found else 0)
        return
    yield from _violations(tree, TableFile(name, tuple(text.splitlines())), data, exercise)


def read_requirements(tree: Tree, stem: str) -> tuple[Requirement, ...]:
    """Read the rows of a table that has no violations."""
    data = tomllib.loads((tree.requirements / f"{stem}.toml").read_text(encoding="utf-8"))
    return tuple(_requirement(number, row) for number, row in enumerate(data["requirement"]))


def _violations(
    tree: Tree, file: TableFile, data: Mapping[str, Any], exercise: Exercise | None
) -> Iterator[Violation]:
    malformed = list(_form(file, data))
    yield from malformed
    raw = data.get("requirement")
    rows = [_requirement(number, one) for number, one in enumerate(raw)] if _is_rows(raw) else []
    yield from _same_ids(file, rows)
    if exercise is not None:
        yield from _unknown_sentences(file, rows, exercise)
        if not malformed:
            yield from _untied(file, rows, exercise)
        yield from _names(tree, file, rows, exercise, whole=not malformed)


def _is_rows(raw: object) -> TypeGuard[list[dict[str, Any]]]:
    return isinstance(raw, list) and all(isinstance(one, dict) for one in raw)


def _form(file: TableFile, data: Mapping[str, Any]) -> Iterator[Violation]:
    """Yield a violation for each part of the data that doesn't have the form of a requirements table."""
    text = "\n".join(file.lines)
    for key in data:
        if key != "requirement":
            words = f"unknown key {key!r}: a table holds [[requirement]] only"
            yield Violation(file.name, words, line_of(text, rf"^\s*\[*\s*{re.escape(key)}\b"))
    if not data:
        yield Violation(file.name, "holds no [[requirement]]: write one for each demand of the task")
    elif "requirement" in data:
        rows = data["requirement"]
        if not (_is_rows(rows) and rows):
            words = "each requirement begins with the line [[requirement]], in two pairs of brackets"
            yield Violation(file.name, words, line_of(text, r"^\s*\[?\s*requirement\b"))
        else:
            for number, row in enumerate(rows):
                yield from _row_form(file, number, row)


def _row_form(file: TableFile, number: int, raw: Mapping[str, Any]) -> Iterator[Violation]:
    one = _requirement(number, raw)
    unknown = [key for key in raw if key not in KEYS]
    for key in unknown:
        words = f"{one.title}: unknown key {key!r}{_guess(key, KEYS)}; there are {', '.join(KEYS)}"
        yield file.at_key(number, key, words)
    if unknown:  # a field that seems to be missing may just be misspelled
        return
    if "id" not in raw:
        yield file.at_key(number, "id", f'{one.title} has no id: give it one, such as "keeps-its-rate"')
    elif not _ID.fullmatch(one.id):
        words = f"the id {raw['id']!r} must be small letters and digits, in words joined by '-': \"keeps-its-rate\""
        yield file.at_key(number, "id", words)
    if not one.sentences:
        yield file.at_key(
            number, "sentence", f"{one.title}: sentence must be a text of the task, or a list of texts"
        )
    for key in ("criteria", "wrong"):
        if key in raw and not getattr(one, key):
            yield file.at_key(number, key, f"{one.title}: {key} must be a list of names, at least one")
    if "not_judged" in raw and not one.not_judged:
        yield file.at_key(number, "not_judged", f"{one.title}: not_judged must say why")
    yield from _judged_or_not(file, one, raw)


def _judged_or_not(file: TableFile, one: Requirement, raw: Mapping[str, Any]) -> Iterator[Violation]:
    if "not_judged" in raw:
        if both := [key for key in ("criteria", "wrong") if key in raw]:
            words = (
                f"{one.title} has not_judged and {' and '.join(both)}: it is judged or it is not, delete one"
            )
            yield file.at_key(one.row, "not_judged", words)
    elif "criteria" not in raw and "wrong" not in raw:
        words = (
            f"nothing judges {one.title}. Name its criteria and the wrong answers that break it, "
            "or say under not_judged why no criterion looks at it"
        )
        yield file.at_key(one.row, "id", words)
    elif "wrong" not in raw:
        words = f"{one.title} has criteria and no wrong: name the wrong answers that break it, or write one"
        yield file.at_key(one.row, "criteria", words)
    elif "criteria" not in raw:
        words = f"{one.title} has wrong answers and no criteria: name the criteria that judge it"
        yield file.at_key(one.row, "wrong", words)


def _requirement(number: int, raw: Mapping[str, Any]) -> Requirement:
    """Return a row's requirement. Invalid fields are empty."""
    sentence, reason = raw.get("sentence"), raw.get("not_judged")
    return Requirement(
        row=number,
        id=raw["id"] if isinstance(raw.get("id"), str) else "",
        sentences=_texts([sentence] if isinstance(sentence, str) else sentence),
        criteria=_texts(raw.get("criteria")),
        wrong=_texts(raw.get("wrong")),
        not_judged=reason.strip() if isinstance(reason, str) else "",
    )


def _texts(value: object) -> tuple[str, ...]:
    """Return a list of strings as a tuple.

    If the value is anything else, or if one of the strings is blank, return an empty tuple.
    """
    if isinstance(value, list) and all(isinstance(one, str) and one.strip() for one in value):
        return tuple(value)
    return ()


def _same_ids(file: TableFile, rows: list[Requirement]) -> Iterator[Violation]:
    first: dict[str, int] = {}
    for one in rows:
        if one.id and first.setdefault(one.id, one.row) != one.row:
            words = (
                f"the id {one.id!r} is the id of requirement {first[one.id] + 1} as well: give each its own"
            )
            yield file.at_key(one.row, "id", words)


def _unknown_sentences(file: TableFile, rows: list[Requirement], exercise: Exercise) -> Iterator[Violation]:
    task = task_text(exercise.source)
    known = folded(task)
    for one in rows:
        for quote in one.sentences:
            if folded(quote) not in known:
                yield file.at_text(one.row, quote, f"{one.title}: {missing_words(quote, task)}")


def _untied(file: TableFile, rows: list[Requirement], exercise: Exercise) -> Iterator[Violation]:
    """Yield a violation for each sentence of the task that demands or forbids something and that no row quotes."""
    quotes = [quote for one in rows for quote in one.sentences]
    for sentence, word in untied_demands(task_text(exercise.source), quotes):
        words = (
            f"no requirement quotes the sentence {sentence!r}, which demands something ({word!r}). Quote it where a "
            "criterion judges it or under not_judged, or take it out of the task"
        )
        yield Violation(file.name, words)


def _names(
    tree: Tree, file: TableFile, rows: list[Requirement], exercise: Exercise, *, whole: bool
) -> Iterator[Violation]:
    """Yield a violation for each name of an unknown criterion or wrong answer, or of a wrong answer in the wrong row.

    If `whole` is true, the table is well-formed. Then also yield the criteria and wrong answers that no row names.
    """
    folder = tree.wrong_answers / exercise.stem
    wrong = [path.stem for path in entries(folder) if path.suffix == ".py"]
    criteria = {one.id: one.points for one in exercise.criteria}
    named: set[str] = set()
    broken: set[str] = set()
    for one in rows:
        for name in one.criteria:
            named |= {name, *_nearest(name, criteria)}
            if name not in criteria:
                words = (
                    f"there is no criterion {name!r}{_guess(name, criteria)}; there are {', '.join(criteria)}"
                )
                yield file.at_name(one.row, name, f"{one.title}: {words}")
        for name in one.wrong:
            broken |= {name, *_nearest(name, wrong)}
            if name not in wrong:
                words = f"there is no wrong answer {name!r}{_guess(name, wrong)}"
                yield file.at_name(
                    one.row, name, f"{one.title}: {words}; {tree.name(folder)}/{name}.py is missing"
                )
            elif _is_elsewhere(lost := _lost(folder / f"{name}.py"), one, criteria):
                words = f"the wrong answer {name!r} loses {', '.join(sorted(lost))}, and none of its criteria"
                yield file.at_name(one.row, name, f"{one.title}: {words}: it belongs to another requirement")
    if not whole:
        return
    for name, worth in criteria.items():
        if worth and name not in named:
            words = f"the criterion {name!r} is worth {points(worth)} points, and no requirement names it: "
            yield Violation(file.name, f"{words}which sentence of the task does it judge?")
    for name in wrong:
        if name not in broken:
            words = f"the wrong answer {name!r} belongs to no requirement: name it under `wrong` of the one it breaks"
            yield Violation(file.name, words)


def _is_elsewhere(lost: frozenset[str], one: Requirement, criteria: Iterable[str]) -> bool:
    """Return whether a wrong answer that loses the criteria in `lost` violates a different requirement than `one`.

    Return False if the answer's header or the requirement's criteria can't be read.
    """
    named = {*one.criteria}
    return bool(lost and named) and named <= {*criteria} and not named & lost


def _lost(path: Path) -> frozenset[str]:
    """Return the criteria that a wrong answer's header says it must lose, or an empty set for an invalid header."""
    try:
        return read_header(path).loses
    except WrongAnswerError:
        return frozenset()


def _nearest(name: str, known: Iterable[str]) -> list[str]:
    return get_close_matches(name, list(known), n=1)


def _guess(name: str, known: Iterable[str]) -> str:
    near = _nearest(name, known)
    return f" (did you mean {near[0]!r}?)" if near else ""
