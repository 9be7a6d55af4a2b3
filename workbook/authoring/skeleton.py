"""Create a new lesson or exercise from a template. The result is small and complete, and it passes every check.

A template is a file or a folder in `skeletons/`. Placeholders such as `@SLUG@` are replaced with parts of the new name.
A line that ends with `@EXAMPLE@` contains text that the author has to replace; see `still_from_template`.
"""

import re
from collections.abc import Iterator
from pathlib import Path

from workbook.authoring.tree import AuthoringError, Tree
from workbook.authoring.violations import Violation
from workbook.exercise.source import STEM

SKELETONS = Path(__file__).with_name("skeletons")
TEMPLATES = ("publisher", "listener", "service", "function")
"""Templates for exercises: a publisher's rate and value, a reaction to a sensor, a service call, and a function."""
EXAMPLE = "@EXAMPLE@"
_SLUG = re.compile(r"[a-z][a-z0-9_]*")


def new_lesson(tree: Tree, name: str) -> list[Path]:
    """Write a new lesson's text and return its path. `name` is a slug, or a stem (NN_slug).

    Raises:
        AuthoringError: the name isn't a valid slug, or the number or name is taken.
    """
    stem = _stem(tree, name, tree.lesson_stems(), tree.exercise_stems())
    return _write(_lesson_files(tree, stem), _words(tree, stem))


def new_exercise(tree: Tree, name: str, template: str = TEMPLATES[0]) -> list[Path]:
    """Write a new exercise: source, criteria, right and wrong answers, requirements, and a driver if it needs one.

    `name` is a slug, or a stem (NN_slug). Return the paths of the written files.

    Raises:
        AuthoringError: the name isn't a valid slug, the number or name is taken, or the template doesn't exist.
    """
    if template not in TEMPLATES:
        raise AuthoringError(f"no template {template!r}: there are {', '.join(TEMPLATES)}")
    stem = _stem(tree, name, tree.exercise_stems(), tree.lesson_stems())
    return _write(_exercise_files(tree, stem, template), _words(tree, stem))


def _lesson_files(tree: Tree, stem: str) -> list[tuple[Path, Path]]:
    return [(SKELETONS / "lesson.py.txt", tree.sources / f"{stem}.py")]


def _exercise_files(tree: Tree, stem: str, template: str) -> list[tuple[Path, Path]]:
    """Return pairs of a template file and the file to write."""
    folder = SKELETONS / "exercises" / template
    files = [
        (folder / "solution.py.txt", tree.solutions / f"{stem}.py"),
        (folder / "criteria.py.txt", tree.criteria / f"{stem}.py"),
    ]
    driver = folder / "driver.py.txt"
    if driver.is_file():
        files.append((driver, tree.drivers / f"{stem}.py"))
    for kind, answers in (("right_answers", tree.right_answers), ("wrong_answers", tree.wrong_answers)):
        for path in sorted((folder / kind).glob("*.py.txt")):
            files.append((path, answers / stem / path.name.removesuffix(".txt")))
    files.append((folder / "requirements.toml.txt", tree.requirements / f"{stem}.toml"))
    return files


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
            raise AuthoringError(f"{other} is there already: change it, or choose another name")
        if other[:2] == stem[:2]:
            raise AuthoringError(f"number {stem[:2]} is taken by {other}")
    return stem


def _words(tree: Tree, stem: str) -> dict[str, str]:
    slug = stem[3:]
    own = [other for other in tree.exercise_stems() if other[:2] == stem[:2]]
    return {
        "STEM": stem,
        "NUMBER": stem[:2],
        "SLUG": slug,
        "SLUG_AS_NAME": slug.replace("_", "-"),
        "TITLE": slug.replace("_", " ").capitalize(),
        "EXERCISE_LINK": f", then [the exercise](../exercises/{own[0]}.ipynb)" if own else "",
    }


def _write(files: list[tuple[Path, Path]], words: dict[str, str]) -> list[Path]:
    there = [target for _, target in files if target.exists()]
    if there:
        raise AuthoringError(f"{there[0]} is there already")
    return list(_written(files, words))


def _written(files: list[tuple[Path, Path]], words: dict[str, str]) -> Iterator[Path]:
    for template, target in files:
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(_filled(template, words).replace(EXAMPLE, ""), encoding="utf-8")
        yield target


def _filled(template: Path, words: dict[str, str]) -> str:
    text = template.read_text(encoding="utf-8")
    for name, word in words.items():
        text = text.replace(f"@{name}@", word)
    return text


def still_from_template(tree: Tree) -> Iterator[Violation]:
    """Yield a note for each line of a template that its author hasn't replaced yet. These notes aren't failures."""
    for stem in tree.lesson_stems():
        yield from _example_lines(tree, stem, _lesson_files(tree, stem))
    for stem in tree.exercise_stems():
        for template in TEMPLATES:
            yield from _example_lines(tree, stem, _exercise_files(tree, stem, template))


def _example_lines(tree: Tree, stem: str, files: list[tuple[Path, Path]]) -> Iterator[Violation]:
    words = _words(tree, stem)
    for template, target in files:
        if not target.is_file():
            continue
        marked = {
            line.removesuffix(EXAMPLE)
            for line in _filled(template, words).splitlines()
            if line.endswith(EXAMPLE)
        }
        for number, line in enumerate(target.read_text(encoding="utf-8").splitlines(), start=1):
            if line in marked:
                yield Violation(
                    tree.name(target), f"is still the template's text: {line.strip('#| ')}", number
                )
