"""Measure a lesson: words of open text, words in folds, cells, and the minutes that a reader needs.

Open text is visible right away: Markdown without code, including each prediction's question and options. Folds contain
the answers to questions, and the explanations that a prediction shows after the run.
"""

import math
import re
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass

from workbook.authoring.document import Cell, Document
from workbook.authoring.lesson import read_lesson
from workbook.authoring.tree import AuthoringError, Tree

WORDS_PER_MINUTE = 180
LIMITS = {"open words": 2_000, "words in folds": 1_200, "cells": 60}
TOO_LARGE = "too_large.toml"
STEP = 5
"""Minutes are rounded up to a multiple of this, because readers don't plan to the minute."""
_FENCE = re.compile(r"^(?P<fence>`{3,}|~{3,}).*?^(?P=fence)", re.MULTILINE | re.DOTALL)
_COMMAND = re.compile(r"^    .*$", re.MULTILINE)
_FOLD = re.compile(r"<details>(?P<inside>.*?)</details>", re.DOTALL)
_TAG = re.compile(r"</?[a-z]+>")
_TARGET = re.compile(r"\]\([^)]*\)")
_QUESTION = re.compile(r"^\*\*\d\. ", re.MULTILINE)
_ASKS_ONLY = re.compile(r"\A(?:\s*from workbook\.lesson import [^\n]+\n+)?\s*predict\([^)]*\)\s*\Z")
_MINUTES = re.compile(r"(?P<before>^# - \*\*Minutes:\*\* )(?P<number>\d+)$", re.MULTILINE)


@dataclass(frozen=True)
class Size:
    """The amount of text, cells, and questions in a lesson."""

    open_words: int
    fold_words: int
    cells: int
    runs: int
    """Code cells to run and understand: all but those that only ask for a prediction."""
    asked: int
    """Predictions and questions."""

    @property
    def over(self) -> dict[str, int]:
        """The sizes that exceed their limit, keyed by the limit's name."""
        found = {"open words": self.open_words, "words in folds": self.fold_words, "cells": self.cells}
        return {name: number for name, number in found.items() if number > LIMITS[name]}

    @property
    def minutes(self) -> int:
        """The minutes that a reader needs, rounded up to a multiple of `STEP`.

        Reading takes a minute per `WORDS_PER_MINUTE` words. Each cell to run, prediction, and question adds a minute.
        """
        reading = (self.open_words + self.fold_words) / WORDS_PER_MINUTE
        return STEP * math.ceil((reading + self.runs + self.asked) / STEP)


def size_of(lesson: Document) -> Size:
    """Compute a lesson's size from its text alone."""
    markdown = [_prose(cell) for cell in lesson.cells if cell.kind == "markdown"]
    folds = [fold["inside"] for text in markdown for fold in _FOLD.finditer(text)]
    folds += [option.why for prediction in lesson.predictions for option in prediction.options]
    code = [cell for cell in lesson.cells if cell.kind == "code"]
    return Size(
        open_words=sum(words(_FOLD.sub(" ", text)) for text in markdown),
        fold_words=sum(map(words, folds)),
        cells=len(lesson.cells),
        runs=sum(not _ASKS_ONLY.match(cell.source) for cell in code),
        asked=len(lesson.predictions) + sum(len(_QUESTION.findall(text)) for text in markdown),
    )


def words(text: str) -> int:
    """Count the words in a text. A word contains a letter or a digit; tags and link targets don't count."""
    bare = _TARGET.sub("]", _TAG.sub(" ", text))
    return sum(any(letter.isalnum() for letter in word) for word in bare.split())


def with_minutes(text: str, minutes: int) -> str:
    """Return a lesson's text with its *Minutes* line set to `minutes`."""
    return _MINUTES.sub(rf"\g<before>{minutes}", text, count=1)


def minutes_in(text: str) -> int | None:
    """Return the number in a lesson's *Minutes* line, or None if there is no such line."""
    found = _MINUTES.search(text)
    return int(found["number"]) if found else None


def _prose(cell: Cell) -> str:
    return _COMMAND.sub("", _FENCE.sub("", cell.source))


def write_sizes(tree: Tree) -> list[str]:
    """Correct the *Minutes* line of all lessons and lower the stored limits of lessons that are too large.

    Return the stems of the lessons whose text changed.
    """
    changed, kept, left = [], still_too_large(tree), {}
    for stem in tree.lesson_stems():
        path = tree.sources / f"{stem}.py"
        text = path.read_text(encoding="utf-8")
        try:
            size = size_of(read_lesson(tree, stem))
        except AuthoringError:  # building the lesson reports it
            left[stem] = kept.get(stem, {})
            continue
        if (right := with_minutes(text, size.minutes)) != text:
            path.write_text(right, encoding="utf-8")
            changed.append(stem)
        allowed = kept.get(stem, {})
        left[stem] = {name: min(size.over[name], most) for name, most in allowed.items() if name in size.over}
    if left != kept and kept:
        _keep(tree, left)
    return changed


def still_too_large(tree: Tree) -> dict[str, dict[str, int]]:
    """Return the higher limits for lessons that are older than the limits, keyed by stem and by the limit's name."""
    path = tree.sources / TOO_LARGE
    return tomllib.loads(path.read_text(encoding="utf-8")) if path.is_file() else {}


def size_violations(tree: Tree, stem: str, text: str, lesson: Document) -> Iterator[tuple[int, str]]:
    """Yield a line (0 for the file) and a message for each size over its limit, and for a wrong *Minutes* line."""
    size = size_of(lesson)
    kept = still_too_large(tree).get(stem, {})
    for name, number in size.over.items():
        most = max(kept.get(name, 0), LIMITS[name])
        if number > most:
            yield 0, f"{number} {name}, but at most {most} are allowed: cut, or move a part to {stem}_deeper"
    if (told := minutes_in(text)) is not None and told != size.minutes:
        yield (
            text[: text.index("**Minutes:**")].count("\n") + 1,
            f"takes {size.minutes} minutes according to its size, but says {told}: run `make notebooks`",
        )


def _keep(tree: Tree, numbers: dict[str, dict[str, int]]) -> None:
    lines = [
        "# Lessons that are still too large, by how much; `make notebooks` lowers the numbers, nothing raises them."
    ]
    for stem, over in sorted(numbers.items()):
        if over:
            lines += ["", f"[{stem}]", *(f'"{name}" = {number}' for name, number in over.items())]
    (tree.sources / TOO_LARGE).write_text("\n".join(lines) + "\n", encoding="utf-8")
