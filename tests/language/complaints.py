"""Find texts that break the style: words from the list, and sentences that are too long.

`python -m tests.language.complaints` prints each with its place. `allowed.toml` lists exceptions with their reasons.
"""

import tomllib
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import cache
from pathlib import Path

from tests.language.texts import (
    CATALOGS,
    CODE,
    EXPLAINED,
    LESSONS,
    MUSEUM,
    PAGES,
    TASKS,
    TEMPLATES,
    Passage,
    catalog_passages,
    comment_passages,
    length,
    museum_passages,
    page_passages,
    paths,
    script_passages,
    sentences,
    string_passages,
    template_passages,
    without_questions,
)
from tests.language.word_list import RULES

ALLOWED = Path(__file__).with_name("allowed.toml")
MOST_WORDS = 25
"""Per sentence."""
LONG_SENTENCE = "long sentence"
"""The rule's name in `allowed.toml`."""
SOURCES: Sequence[tuple[Sequence[str], Callable[[Path], Iterator[Passage]]]] = (
    (PAGES, page_passages),
    (TASKS, script_passages),
    (LESSONS, script_passages),
    (MUSEUM, museum_passages),
    (CODE, string_passages),
    (CATALOGS, catalog_passages),
    (TEMPLATES, template_passages),
)
EXPLANATIONS = ((EXPLAINED, comment_passages),)
"""Docstrings and comments."""


@cache
def all_passages() -> tuple[Passage, ...]:
    """Return every passage that a person reads."""
    return tuple(
        passage
        for patterns, passages in (*SOURCES, *EXPLANATIONS)
        for path in paths(patterns)
        for passage in passages(path)
    )


@cache
def exceptions() -> list[dict[str, str]]:
    """Return the exceptions: the rule, the file, a piece of the text, the reason."""
    found: list[dict[str, str]] = tomllib.loads(ALLOWED.read_text(encoding="utf-8")).get("allowed", [])
    return found


def is_allowed(rule: str, path: str, text: str) -> bool:
    """Return whether an exception covers a rule in a text of a file."""
    return any(one["rule"] == rule and one["file"] == path and one["text"] in text for one in exceptions())


def broken_rules(passage: Passage) -> Iterator[tuple[str, str, str]]:
    """Return how a passage breaks the style: the rule, the text that breaks it, and a message for the author."""
    for rule, old in RULES.items():
        asked = passage.text if old.questions else without_questions(passage)
        for words in old.found(asked):
            yield rule, passage.text, f"{words!r}; write: {old.instead}"
    for sentence in sentences(passage):
        if length(sentence) > MOST_WORDS:
            yield LONG_SENTENCE, sentence, f"{length(sentence)} words, {MOST_WORDS} at most: {sentence}"


def complaints(passages: Iterable[Passage]) -> Iterator[str]:
    """Return each place that breaks a rule and isn't covered by an exception."""
    for passage in passages:
        for rule, text, words in broken_rules(passage):
            if not is_allowed(rule, passage.path, text):
                yield f"{passage.where}: {words}"


if __name__ == "__main__":
    for complaint in complaints(all_passages()):
        print(complaint)
