"""Wrong answers name causes that exist, and say only what the kept words of a cause leave open."""

import re
import tomllib
from collections.abc import Iterator
from functools import cache

import pytest

from tests.criteria.words_of import ROOT, WORDS, exercises, vocabulary
from workbook.authoring.tree import Tree, entries
from workbook.authoring.wrong_answers import Header, read_header

STEMS = Tree(ROOT).exercise_stems()


def headers(stem: str) -> Iterator[tuple[str, Header]]:
    for path in entries(Tree(ROOT).wrong_answers / stem):
        yield path.name, read_header(path)


@cache
def kept_words(stem: str) -> dict[str, list[str]]:
    """What the exercise and the vocabulary say, by cause: the texts between what is filled in."""
    found: dict[str, list[str]] = {}
    for path in WORDS.glob("*.toml"):
        if path.stem in STEMS and path.stem != stem:
            continue
        for cause, parts in tomllib.loads(path.read_text(encoding="utf-8")).items():
            texts = [text for part in parts.values() for text in ([part] if isinstance(part, str) else part)]
            found[cause] = [piece for text in texts for piece in re.split(r"\{[^{}]*\}", text)]
    return found


@pytest.mark.parametrize("stem", STEMS)
def test_every_wrong_answer_names_a_cause_that_exists(stem: str) -> None:
    paths = [path for path in (*exercises(), *vocabulary()) if path.stem not in STEMS or path.stem == stem]
    named = "\n".join(path.read_text(encoding="utf-8") for path in paths)
    causes = {name: header.causes for name, header in headers(stem)}
    assert not {name for name, some in causes.items() if not some}
    assert not {name: cause for name, some in causes.items() for cause in some if f'"{cause}"' not in named}


@pytest.mark.parametrize("stem", STEMS)
def test_a_wrong_answer_does_not_repeat_the_words_of_its_cause(stem: str) -> None:
    """They are compared once, in `tests/criteria/words`; `# says:` is for a number or a name of the answer's own."""
    words = kept_words(stem)
    repeated = [
        f"{name}: {says}"
        for name, header in headers(stem)
        for says in header.says
        if any(says in piece for cause in header.causes for piece in words.get(cause, ()))
    ]
    assert not repeated
