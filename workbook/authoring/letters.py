"""Check that the correct options' letters are balanced, so that always guessing the same letter doesn't pay off."""

import re
from collections import Counter
from collections.abc import Iterator, Sequence

from workbook.authoring.lesson import read_lesson
from workbook.authoring.tree import AuthoringError, Tree
from workbook.authoring.violations import Violation

LARGEST_SHARE_IN_COURSE = 0.4
LARGEST_SHARE_IN_LESSON = 0.6
FEWEST_IN_COURSE, FEWEST_IN_LESSON = 20, 4
"""With fewer letters than these, fractions aren't meaningful, so they aren't checked."""
_RIGHT = re.compile(r"<summary>(?P<letter>[a-z])\) [^\n]*</summary>\s*✓")


def prediction_letters(tree: Tree) -> dict[str, list[str]]:
    """Return a list for each lesson: the letters that usually answer its predictions. Skip unreadable lessons."""
    found = {}
    for stem in tree.lesson_stems():
        try:
            found[stem] = [one.usual for one in read_lesson(tree, stem).predictions]
        except AuthoringError:
            continue
    return found


def question_letters(tree: Tree) -> dict[str, list[str]]:
    """Return a list for each lesson: the letters of the correct options in its "Check yourself" questions."""
    found = {}
    for stem in tree.lesson_stems():
        lines = (tree.sources / f"{stem}.py").read_text(encoding="utf-8").splitlines()
        text = "\n".join(line.removeprefix("#").removeprefix(" ") for line in lines)
        found[stem] = [match["letter"] for match in _RIGHT.finditer(text)]
    return found


def letter_violations(tree: Tree) -> Iterator[Violation]:
    """Yield a violation for each letter that is correct too often, in one lesson or in the whole course."""
    for what, by_lesson in (
        ("predictions", prediction_letters(tree)),
        ("questions", question_letters(tree)),
    ):
        for stem, letters in by_lesson.items():
            if len(letters) >= FEWEST_IN_LESSON:
                words = _too_often(what, letters, LARGEST_SHARE_IN_LESSON)
                yield from (Violation(tree.name(tree.sources / f"{stem}.py"), one) for one in words)
        everywhere = [letter for letters in by_lesson.values() for letter in letters]
        if len(everywhere) >= FEWEST_IN_COURSE:
            words = _too_often(what, everywhere, LARGEST_SHARE_IN_COURSE)
            yield from (Violation(tree.name(tree.sources), f"in the course, {one}") for one in words)


def _too_often(what: str, letters: Sequence[str], largest: float) -> Iterator[str]:
    for letter, times in Counter(letters).items():
        if times > largest * len(letters):
            yield f"{letter} is right in {times} of {len(letters)} {what}; at most {largest:.0%} are allowed"
