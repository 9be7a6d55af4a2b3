"""Rules for exercises: the facts that the story must state, the points, and the answers that test the judge."""

import re
from collections.abc import Iterator
from pathlib import Path

from workbook.authoring.tree import AuthoringError, Tree, entries
from workbook.authoring.violations import Violation, line_of
from workbook.authoring.wrong_answers import read_wrong_answer
from workbook.exercise.definition import Exercise
from workbook.feedback.wording import points

ALL_POINTS = 10.0
FEWEST_CRITERIA = 4
"""Minimum number of criteria that earn points. With several, students see their progress, and which parts are missing.
"""
FEWEST_RIGHT = 3
FEWEST_WRONG = 5
_TABLE_ROW = r"\| *(\d+(?:\.\d+)?) *\|"

_AT_LINE = re.compile(r"(?P<file>[^:\s]+\.py):(?P<line>\d+): (?P<words>.*)", re.DOTALL)
_IN_FILE = re.compile(r"(?P<file>[^:\s]+\.py): (?P<words>.*)", re.DOTALL)


def from_error(tree: Tree, error: AuthoringError, where: Path) -> Violation:
    """Convert an error into a violation at the file and line in its message, or in `where` if the message has none."""
    text = str(error).replace(f"{tree.root}/", "")
    if found := _AT_LINE.fullmatch(text):
        return Violation(found["file"], found["words"], int(found["line"]))
    if found := _IN_FILE.fullmatch(text):
        return Violation(found["file"], found["words"])
    return Violation(tree.name(where), text)


def story_violations(tree: Tree, exercise: Exercise) -> Iterator[Violation]:
    """Check that the story states the title, minutes, difficulty, and points that the header and criteria define."""
    source = exercise.source
    story = "\n".join(source.story)
    text = exercise.solution_path.read_text(encoding="utf-8")

    def at(pattern: str, words: str) -> Violation:
        return Violation(tree.name(exercise.solution_path), words, line_of(text, pattern))

    for wanted, pattern in (
        (f"{source.minutes} minutes", r"^# minutes:"),
        (f"difficulty {source.difficulty} of 5", r"^# difficulty:"),
        (f"{points(exercise.max_points)} points", r"^# # "),
    ):
        if wanted not in story:
            yield at(pattern, f"the story must say '{wanted}', as header and criteria do")
    title = f"# Exercise {source.number:02d} · "
    if not source.story[0].startswith(title):
        yield at(r"^# # ", f"the story must begin with '{title}{source.title}'")
    told = sum(float(number) for number in re.findall(rf"^{_TABLE_ROW}", story, re.MULTILINE))
    shown = sum(one.points for one in exercise.criteria if not one.hidden)
    if abs(told - shown) > 1e-9:
        yield at(
            rf"^# {_TABLE_ROW}",
            "the table of points must have rows '| 2 | the criterion |' that add up to "
            f"{points(shown)}, not {points(told)}",
        )


def points_violations(tree: Tree, exercise: Exercise) -> Iterator[Violation]:
    """Check that the points add up to ten, and that at least four criteria earn points."""
    path = tree.criteria / f"{exercise.stem}.py"
    line = line_of(path.read_text(encoding="utf-8"), r"^@criterion\(")
    if exercise.max_points != ALL_POINTS:
        words = f"the points of all criteria must add up to {points(ALL_POINTS)}, not {points(exercise.max_points)}"
        yield Violation(tree.name(path), words, line)
    earning = sum(one.points > 0 for one in exercise.criteria)
    if earning < FEWEST_CRITERIA:
        words = f"{earning} criteria earn points, but at least {FEWEST_CRITERIA} must: split a criterion"
        yield Violation(tree.name(path), words, line)


def answer_violations(tree: Tree, stem: str, exercise: Exercise | None) -> Iterator[Violation]:
    """Check that there are enough right and wrong answers, and that wrong answers name only existing criteria.

    If the exercise couldn't be read (`exercise` is None), don't check the names of the criteria.
    """
    for folder, fewest, kind in (
        (tree.right_answers / stem, FEWEST_RIGHT, "right"),
        (tree.wrong_answers / stem, FEWEST_WRONG, "wrong"),
    ):
        answers = list(entries(folder))
        for path in answers:
            if not (path.is_file() and path.suffix == ".py"):
                yield Violation(tree.name(path), "does not belong here: answers are Python files")
            elif kind == "wrong" and exercise is not None:
                yield from _wrong_answer(tree, path, exercise)
        count = sum(path.suffix == ".py" for path in answers)
        if count < fewest:
            yield Violation(tree.name(folder), f"has {count} {kind} answers, but needs at least {fewest}")


def _wrong_answer(tree: Tree, path: Path, exercise: Exercise) -> Iterator[Violation]:
    try:
        header = read_wrong_answer(tree, path).header
    except AuthoringError as error:
        yield from_error(tree, error, path)
        return
    known = [one.id for one in exercise.criteria]
    text = path.read_text(encoding="utf-8")
    for field, names in (("loses", header.loses), ("skips", header.skips or ())):
        for name in sorted(names):
            if name not in known:
                words = f"there is no criterion {name!r}: there are {', '.join(known)}"
                yield Violation(tree.name(path), words, line_of(text, rf"^# {field}:.*\b{re.escape(name)}\b"))
