"""Writes the skeleton of a lesson or an exercise: all that the checks demand, with `TODO(author)` where you write."""

import re
from collections.abc import Iterator
from pathlib import Path

from workbook.authoring.tree import AuthoringError, Tree
from workbook.exercise.source import STEM

SKELETONS = Path(__file__).with_name("skeletons")
_SLUG = re.compile(r"[a-z][a-z0-9_]*")


def new_lesson(tree: Tree, name: str) -> list[Path]:
    """Write the text of a new lesson. `name` is a slug, or a stem with its number. Returns the files.

    Raises:
        AuthoringError: the name is no slug, or the number or the name is taken.
    """
    stem = _stem(tree, name, tree.lesson_stems(), tree.exercise_stems())
    own = [other for other in tree.exercise_stems() if other[:2] == stem[:2]]
    later = [other for other in tree.lesson_stems() if other > stem]
    words = _words(stem) | {
        "EXERCISE_LINK": f", then [the exercise](../exercises/{own[0]}.ipynb)" if own else "",
        "NEXT": f"[{later[0][:2]}]({later[0]}.ipynb)" if later else "TODO(author): the next lesson",
    }
    return _write([(SKELETONS / "lesson.py.txt", tree.sources / f"{stem}.py")], words)


def new_exercise(tree: Tree, name: str) -> list[Path]:
    """Write source, criteria, right and wrong answers of a new exercise, which can be judged as it is.

    Raises:
        AuthoringError: the name is no slug, or the number or the name is taken.
    """
    stem = _stem(tree, name, tree.exercise_stems(), tree.lesson_stems())
    files = [
        (SKELETONS / "solution.py.txt", tree.solutions / f"{stem}.py"),
        (SKELETONS / "criteria.py.txt", tree.criteria / f"{stem}.py"),
    ]
    for kind, folder in (("right_answers", tree.right_answers), ("wrong_answers", tree.wrong_answers)):
        for path in sorted((SKELETONS / kind).glob("*.py.txt")):
            files.append((path, folder / stem / path.name.removesuffix(".txt")))
    return _write(files, _words(stem))


def _stem(tree: Tree, name: str, taken: tuple[str, ...], partners: tuple[str, ...]) -> str:
    given = STEM.fullmatch(name)
    slug = given["slug"] if given else name
    if not _SLUG.fullmatch(slug):
        raise AuthoringError(
            f"{name!r} cannot be a name: use small letters, digits and _, like slow_callbacks or 10_slow_callbacks"
        )
    partner = next((stem for stem in partners if stem[3:] == slug), None)
    if given:
        stem = name
    elif partner is not None and partner not in taken:
        stem = partner
    else:
        numbers = [int(stem[:2]) for stem in (*taken, *partners)]
        stem = f"{max(numbers, default=-1) + 1:02d}_{slug}"
    for other in taken:
        if other == stem or other[3:] == slug:
            raise AuthoringError(f"{other} is there already")
        if other[:2] == stem[:2]:
            raise AuthoringError(f"number {stem[:2]} is taken by {other}")
    return stem


def _words(stem: str) -> dict[str, str]:
    slug = stem[3:]
    return {"STEM": stem, "NUMBER": stem[:2], "SLUG": slug, "TITLE": slug.replace("_", " ").capitalize()}


def _write(files: list[tuple[Path, Path]], words: dict[str, str]) -> list[Path]:
    there = [target for _, target in files if target.exists()]
    if there:
        raise AuthoringError(f"{there[0]} is there already")
    return list(_written(files, words))


def _written(files: list[tuple[Path, Path]], words: dict[str, str]) -> Iterator[Path]:
    for template, target in files:
        text = template.read_text(encoding="utf-8")
        for name, word in words.items():
            text = text.replace(f"@{name}@", word)
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
        yield target
