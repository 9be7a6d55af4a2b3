"""Generate whole pages, and the parts of the README and the manuals between markers."""

import re
from collections.abc import Iterator
from pathlib import Path

from workbook.authoring.lesson_lists import PLANNED, RUN_TIMES, list_page, table
from workbook.authoring.museum_pages import GLOSSARY, MUSEUM, glossary_page, museum_page, museum_violations
from workbook.authoring.size import TOO_LARGE
from workbook.authoring.tree import AuthoringError, Tree
from workbook.authoring.violations import Violation
from workbook.authoring.vocabulary_list import vocabulary
from workbook.exercise.museum import BrokenMuseum, load_museum

LIST = "README.md"
PAGES = (MUSEUM, GLOSSARY, LIST)
BESIDE_LESSONS = ("museum", PLANNED, RUN_TIMES, TOO_LARGE)
"""The allowed entries next to the lesson texts in their folder."""


def pages(tree: Tree) -> dict[Path, str]:
    """Return the text that each generated page must have, keyed by path.

    Skip README.md and docs/vocabulary.md if they don't exist. Raises AuthoringError if a page lacks its
    markers, and BrokenMuseum if the museum can't be read.
    """
    museum = load_museum(tree.root)
    found = {
        tree.notebooks / MUSEUM: museum_page(tree, museum),
        tree.notebooks / GLOSSARY: glossary_page(tree, museum),
        tree.notebooks / LIST: list_page(tree),
    }
    for name, part, text in (
        ("README.md", "lessons", table(tree)),
        ("docs/vocabulary.md", "vocabulary", vocabulary()),
    ):
        path = tree.root / name
        if path.is_file():
            found[path] = with_part(path.read_text(encoding="utf-8"), part, text, name)
    return found


def with_part(page: str, part: str, text: str, name: str) -> str:
    """Return the page with `text` between the markers of `part`.

    Raises AuthoringError unless the page, called `name` in the message, contains each marker exactly once.
    """
    start, end = f"<!-- {part}: made by `make notebooks` -->", f"<!-- end of {part} -->"
    if page.count(start) != 1 or page.count(end) != 1 or page.index(start) > page.index(end):
        raise AuthoringError(f"{name} needs the lines '{start}' and '{end}', once each")
    head, rest = page.split(start)
    return f"{head}{start}\n\n{text.strip()}\n\n{end}{rest.split(end)[1]}"


def write_pages(tree: Tree) -> list[Path]:
    """Update the pages and return those that changed. Raises the same exceptions as `pages`."""
    changed = []
    for path, text in pages(tree).items():
        if not path.is_file() or path.read_text(encoding="utf-8") != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            changed.append(path)
    return changed


def check_pages(tree: Tree) -> Iterator[Violation]:
    """Yield a violation for each faulty museum entry, and for each page that is missing or out of date."""
    try:
        museum = load_museum(tree.root)
        for name, words in museum_violations(tree, museum):
            path = tree.museum / name
            yield Violation(tree.name(path), words, _named_line(path, words))
        for path, text in pages(tree).items():
            if not path.is_file():
                yield Violation(tree.name(path), "is not there: run `make notebooks`")
            elif (there := path.read_text(encoding="utf-8")) != text:
                yield Violation(
                    tree.name(path),
                    "is not what lessons and exercises say: run `make notebooks`",
                    _first_difference(there, text),
                )
    except BrokenMuseum as error:
        yield Violation(tree.name(tree.museum), str(error))
    except AuthoringError as error:
        name, _, words = str(error).partition(" ")
        yield Violation(name, words)


def _named_line(path: Path, words: str) -> int:
    """Return the number of the file's first line that contains the first quotation in `words`, or 0 if no line does."""
    quoted = re.search(r"'(.+?)'", words)
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        if quoted and quoted[1] in line:
            return number
    return 0


def _first_difference(one: str, other: str) -> int:
    given, wanted = one.splitlines(), other.splitlines()
    for number, (left, right) in enumerate(zip(given, wanted, strict=False), start=1):
        if left != right:
            return number
    return min(len(given), len(wanted)) + 1
