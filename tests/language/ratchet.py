"""How much of the old language is left, per file: counts that may only shrink.

`python -m tests.language.ratchet` writes `ratchet.toml` anew, with smaller counts where a text has become better. It
raises none.
"""

import tomllib
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from functools import cache
from pathlib import Path

from tests.language.texts import (
    CODE,
    LESSONS,
    MUSEUM,
    PAGES,
    ROOT,
    TASKS,
    Passage,
    length,
    museum_passages,
    page_passages,
    paths,
    script_passages,
    sentences,
    string_passages,
)
from tests.language.word_list import RULES

KEPT = Path(__file__).with_name("ratchet.toml")
ALLOWED = Path(__file__).with_name("allowed.toml")
LONG_SENTENCE = 25
"""Words. The style's limit, as a rule."""
COMMAND = "python -m tests.language.ratchet"
SOURCES: Sequence[tuple[Sequence[str], Callable[[Path], Iterator[Passage]]]] = (
    (PAGES, page_passages),
    (TASKS, script_passages),
    (LESSONS, script_passages),
    (MUSEUM, museum_passages),
    (CODE, string_passages),
)


@cache
def all_passages() -> tuple[Passage, ...]:
    """Every passage that a person reads."""
    return tuple(
        passage for patterns, passages in SOURCES for path in paths(patterns) for passage in passages(path)
    )


@cache
def exceptions() -> list[dict[str, str]]:
    """What is allowed for a reason: the rule, the file, a piece of the text, the reason."""
    found: list[dict[str, str]] = tomllib.loads(ALLOWED.read_text(encoding="utf-8")).get("allowed", [])
    return found


def is_allowed(rule: str, passage: Passage) -> bool:
    """Whether an exception covers a rule in a passage."""
    return any(
        one["rule"] == rule and one["file"] == passage.path and one["text"] in passage.text
        for one in exceptions()
    )


def old_words(passage: Passage) -> list[tuple[str, str]]:
    """What a passage says against the word list: the rule, and the words."""
    return [(rule, words) for rule in RULES for words in RULES[rule].found(passage.text)]


def long_sentences(passage: Passage) -> list[str]:
    """The sentences of a passage that are longer than the style allows."""
    return [one for one in sentences(passage) if length(one) > LONG_SENTENCE]


def count() -> tuple[Counter[str], Counter[str]]:
    """For each file: how many words of the list it still has, and how many long sentences."""
    words: Counter[str] = Counter()
    sentences_too_long: Counter[str] = Counter()
    for passage in all_passages():
        words[passage.path] += sum(not is_allowed(rule, passage) for rule, _ in old_words(passage))
        sentences_too_long[passage.path] += len(long_sentences(passage))
    return +words, +sentences_too_long


def kept() -> tuple[dict[str, int], dict[str, int]]:
    """The counts that are kept: of words and of long sentences, by file."""
    found = tomllib.loads(KEPT.read_text(encoding="utf-8")) if KEPT.is_file() else {}
    return found.get("words", {}), found.get("long_sentences", {})


def main() -> None:
    """Write the counts that have become smaller; those of a new table as they are."""
    old_counts, is_new = kept(), not KEPT.is_file()
    lines = [f"# What is left of the old language, by file; may only shrink. Written by `{COMMAND}`."]
    for title, now, old in zip(("words", "long_sentences"), count(), old_counts, strict=True):
        lines += ["", f"[{title}]"]
        fewer = {path: n if is_new else min(n, old.get(path, 0)) for path, n in sorted(now.items())}
        lines += [f'"{path}" = {n}' for path, n in fewer.items() if n]
    KEPT.write_text("\n".join(lines) + "\n", encoding="utf-8")
    print(f"Written: {KEPT.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
